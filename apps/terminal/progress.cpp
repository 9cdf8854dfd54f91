#include "apps/terminal/progress.hpp"

#include "apps/terminal/terminal.hpp"
#include "base/text.hpp"

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <string_view>

namespace matrigrate::apps {

namespace {

using namespace std::chrono_literals;

bool draws_on_terminal() {
  const char* terminal = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

/// Characters of a line of the terminal on the standard error that can be written without a line break.
std::size_t terminal_width() {
  winsize size{};
  long columns = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
  const char* told = std::getenv("COLUMNS");
  if (columns == 0 && told != nullptr) columns = std::strtol(told, nullptr, 10);
  if (columns <= 0) columns = 80;
  return static_cast<std::size_t>(columns) - 1; // some terminals break the line behind their last column
}

/// A bar of `width` characters: "####----".
std::string bar(double share, int width) {
  const int done = std::clamp(static_cast<int>(std::lround(share * width)), 0, width);
  return std::string(static_cast<std::size_t>(done), '#') + std::string(static_cast<std::size_t>(width - done), '-');
}

} // namespace

std::string time_left(double elapsed, double done, double rest) {
  if (!(done > 0.0)) return {};
  return wall_time_text(elapsed * rest / done) + " left";
}

std::string progress_line(const ProgressText& text, std::size_t width) {
  const std::string percent = fmt::format("{:.0f} %", 100.0 * text.share);
  const auto line = [&](int bar_width, std::initializer_list<std::string_view> parts) {
    std::string joined = bar_width > 0 ? fmt::format("[{}] {}", bar(text.share, bar_width), percent) : percent;
    for (const std::string_view part : parts)
      if (!part.empty()) joined.append("  ").append(part);
    return joined;
  };
  for (const std::string& candidate :
       {line(24, {text.where, text.left, text.remark}), line(10, {text.where, text.left, text.remark}),
        line(24, {text.where, text.left}), line(10, {text.where, text.left}), line(0, {text.where, text.left}),
        line(10, {text.left}), line(0, {text.left})})
    if (candidate.size() <= width) return candidate;
  return percent.substr(0, width);
}

Progress::Progress(bool quiet) : m_quiet(quiet), m_terminal(draws_on_terminal()) {}

Progress::~Progress() {
  if (m_drawn) print_error("\r\x1b[K");
}

void Progress::show(const std::function<ProgressText(double elapsed)>& text) {
  const Clock::time_point now = Clock::now();
  if (m_quiet || now - m_last < (m_terminal ? Clock::duration(200ms) : Clock::duration(1min))) return;
  m_last = now;
  const ProgressText shown = text(std::chrono::duration<double>(now - m_start).count());
  print_error(m_terminal ? "\r\x1b[K" + progress_line(shown, terminal_width()) : shown.line + "\n");
  m_drawn = m_terminal;
}

} // namespace matrigrate::apps
