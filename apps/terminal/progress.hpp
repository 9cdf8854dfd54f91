#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace matrigrate::apps {

/// How far a run is, on the standard error: a bar that is redrawn on a terminal, one line per minute elsewhere.
/// Test: tests/apps/progress_test.cpp
class Progress {
public:
  /// @param start  simulated time at which this process begins: the time left is estimated from what it does itself [s]
  /// @param total  simulated time of the whole run [s]
  /// @param quiet  show nothing
  Progress(double start, double total, bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress(); ///< leaves the line of the bar

  /// Shows the state of t if it is time to. @param remark  a few words behind it
  void show(double t, const std::string& remark);

private:
  using Clock = std::chrono::steady_clock;

  double m_begin;
  double m_total;
  bool m_quiet;
  bool m_terminal;
  bool m_drawn = false;
  Clock::time_point m_start = Clock::now();
  Clock::time_point m_last;
};

/// The text beside the bar of a run.
struct ProgressText {
  double share = 0.0; ///< done of the whole, 0 to 1
  std::string where;  ///< "12 min of 1 h"
  std::string left;   ///< "27 s left"; empty while that is not known
  std::string remark;
};

/// The bar and its text in one line of at most `width` characters: what there is no room for is left out, the remark
/// first, the percentage last.
std::string progress_line(const ProgressText& text, std::size_t width);

/// Characters of a line of the terminal on the standard error that can be written without a line break.
std::size_t terminal_width();

/// A bar of `width` characters: "####----".
std::string bar(double share, int width);

/// The time left, estimated from the part done so far: "12 min left"; empty if nothing was done.
/// @param elapsed  on the clock [s]   @param done  in that time   @param rest  still to be done, in the same unit
std::string time_left(double elapsed, double done, double rest);

} // namespace matrigrate::apps
