#pragma once

#include <chrono>
#include <string>

namespace matrigrate::apps {

/// How far a run is, on the standard error: a bar that is drawn anew on a terminal, a line a minute elsewhere.
class Progress {
public:
  /// @param total  simulated time of the whole run [s]
  /// @param quiet  show nothing
  Progress(double total, bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress(); ///< leaves the line of the bar

  /// Shows the state of t if it is time to. @param remark  a few words behind it
  void show(double t, const std::string& remark);

private:
  using Clock = std::chrono::steady_clock;

  double m_total;
  bool m_quiet;
  bool m_terminal;
  bool m_drawn = false;
  Clock::time_point m_start = Clock::now();
  Clock::time_point m_last;
};

/// A bar of `width` characters: "####----".
std::string bar(double share, int width);

/// A stretch of wall time: "45 s", "12 min", "3.2 h".
std::string wall_time_text(double seconds);

} // namespace matrigrate::apps
