#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace matrigrate::apps {

/// How far something is.
struct ProgressText {
  double share = 0.0; ///< done of the whole, 0 to 1
  std::string where;  ///< "12 min of 1 h"
  std::string left;   ///< "27 s left"; empty while that is not known
  std::string remark;
  std::string line = {}; ///< the whole where there is no terminal
};

/// How far a run or a pool is, on the standard error: a bar that is redrawn on a terminal, one line per minute
/// elsewhere. Test: tests/apps/progress_test.cpp
class Progress {
public:
  /// @param quiet  show nothing
  explicit Progress(bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress(); ///< leaves the line of the bar

  /// Shows text(seconds since this object was made) if it is time to.
  void show(const std::function<ProgressText(double elapsed)>& text);

private:
  using Clock = std::chrono::steady_clock;

  bool m_quiet;
  bool m_terminal;
  bool m_drawn = false;
  Clock::time_point m_start = Clock::now();
  Clock::time_point m_last = m_start;
};

/// The bar and its text in one line of at most `width` characters: what there is no room for is left out, the remark
/// first, the percentage last.
std::string progress_line(const ProgressText& text, std::size_t width);

/// The time left, estimated from the part done so far: "12 min left"; empty if nothing was done.
/// @param elapsed  on the clock [s]   @param done  in that time   @param rest  still to be done, in the same unit
std::string time_left(double elapsed, double done, double rest);

} // namespace matrigrate::apps
