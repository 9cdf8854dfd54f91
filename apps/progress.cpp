#include "apps/progress.hpp"

#include "apps/terminal.hpp"
#include "io/cell_picture.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace matrigrate::apps {

namespace {

using namespace std::chrono_literals;

bool draws_on_terminal() {
  const char* terminal = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

} // namespace

std::string bar(double share, int width) {
  const int done = std::clamp(static_cast<int>(std::lround(share * width)), 0, width);
  return std::string(static_cast<std::size_t>(done), '#') + std::string(static_cast<std::size_t>(width - done), '-');
}

std::string wall_time_text(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

Progress::Progress(double total, bool quiet)
    : m_total(total), m_quiet(quiet), m_terminal(draws_on_terminal()), m_last(m_start) {}

Progress::~Progress() {
  if (m_drawn) print_error("\r\x1b[K");
}

void Progress::show(double t, const std::string& remark) {
  const Clock::time_point now = Clock::now();
  if (m_quiet || now - m_last < (m_terminal ? Clock::duration(200ms) : Clock::duration(1min))) return;
  m_last = now;
  const double share = t / m_total;
  const double elapsed = std::chrono::duration<double>(now - m_start).count();
  const std::string rest = wall_time_text(elapsed * (1.0 - share) / share);
  const std::string where = fmt::format("{} of {}", io::time_text(t), io::time_text(m_total));
  if (m_terminal) {
    print_error(
        fmt::format("\r\x1b[K[{}] {:.0f} %  {}  {} left  {}", bar(share, 24), 100.0 * share, where, rest, remark));
    m_drawn = true;
  } else {
    print_error(fmt::format("{} ({:.0f} %), {}, about {} left\n", where, 100.0 * share, remark, rest));
  }
}

} // namespace matrigrate::apps
