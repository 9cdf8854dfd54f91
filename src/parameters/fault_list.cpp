#include "parameters/fault_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <tuple>
#include <utility>

namespace matrigrate {

void FaultList::add(Fault fault, Hint hint) {
  if (!m_seen.insert(std::hash<std::string>{}(to_string(fault))).second) return;
  m_noted.push_back({std::move(fault), std::move(hint)});
  if (m_noted.size() > 4 * max_listed) sort_and_cut();
}

void FaultList::sort_and_cut() {
  const auto order = [&](const Noted& n) {
    return std::tuple(n.fault.file != m_file, n.fault.line > 0 ? n.fault.line : INT_MAX, n.fault.column);
  };
  std::ranges::stable_sort(m_noted, [&](const Noted& a, const Noted& b) { return order(a) < order(b); });
  if (m_noted.size() > max_listed) m_noted.erase(m_noted.begin() + max_listed, m_noted.end());
}

void FaultList::raise() {
  if (empty()) return;
  sort_and_cut();
  std::vector<Fault> faults;
  faults.reserve(m_noted.size() + 1);
  for (Noted& noted : m_noted) {
    if (noted.hint) noted.fault.message += noted.hint();
    faults.push_back(std::move(noted.fault));
  }
  if (m_seen.size() > faults.size())
    faults.push_back({m_file, 0, 0, "", fmt::format("has {} more faults", m_seen.size() - faults.size())});
  throw ConfigurationError(std::move(faults));
}

} // namespace matrigrate
