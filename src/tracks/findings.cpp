#include "tracks/findings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::tracks {

namespace {

constexpr std::size_t most_kinds = 20;

/// A message without its numbers and what it quotes.
std::string kind_of(const std::string& message) {
  std::string kind;
  bool quoted = false;
  for (const char c : message) {
    quoted = quoted != (c == '"');
    if (!quoted && (c < '0' || c > '9') && c != '.') kind += c;
  }
  return kind;
}

} // namespace

void Findings::fault(std::size_t line, const std::string& message) { fault_of_kind(kind_of(message), line, message); }

void Findings::fault_of_kind(const std::string& kind, std::size_t line, const std::string& message) {
  ++m_count;
  const auto [own, added] = m_kinds.emplace(kind, m_faults.size());
  if (!added) {
    if (own->second < m_more.size()) ++m_more[own->second];
  } else if (m_faults.size() < most_kinds) {
    m_faults.push_back({m_file, static_cast<int>(line), line == 0 ? 0 : 1, {}, message});
    m_more.push_back(0);
  }
}

void Findings::raise() {
  if (m_faults.empty()) return;
  std::size_t told = 0;
  for (std::size_t k = 0; k < m_faults.size(); ++k) {
    told += 1 + m_more[k];
    if (m_more[k] > 0) m_faults[k].message += fmt::format(" (and {} more)", m_more[k]);
  }
  std::ranges::stable_sort(m_faults, {}, &Fault::line);
  if (m_count > told) m_faults.push_back({m_file, 0, 0, {}, fmt::format("{} more faults", m_count - told)});
  throw ConfigurationError(std::move(m_faults));
}

std::string counted(std::size_t n, const std::string& one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); }

} // namespace matrigrate::tracks
