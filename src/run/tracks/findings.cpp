#include "tracks/findings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::tracks {

namespace {

constexpr std::size_t most_faults = 20;

} // namespace

void Findings::fault(std::size_t line, std::string message) {
  if (++m_count <= most_faults)
    m_faults.push_back({m_file, static_cast<int>(line), line == 0 ? 0 : 1, {}, std::move(message)});
}

void Findings::raise() {
  if (m_faults.empty()) return;
  std::ranges::stable_sort(m_faults, {}, &Fault::line);
  if (m_count > most_faults)
    m_faults.push_back({m_file, 0, 0, {}, fmt::format("{} more faults", m_count - most_faults)});
  throw ConfigurationError(std::move(m_faults));
}

std::string counted(std::size_t n, const std::string& one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); }

} // namespace matrigrate::tracks
