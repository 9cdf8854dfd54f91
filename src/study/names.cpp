#include "study/names.hpp"

#include "parameters/schema.hpp"
#include "study/settings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::study {

namespace {

/// The last word of a path, or the paper's letters.
std::string short_name(const std::string& key) {
  const Row* row = find_row(key);
  if (row != nullptr && key_of(*row) == "number") return std::string(row->symbol);
  return key.substr(key.rfind('.') + 1);
}

} // namespace

Names::Names(const std::vector<std::string>& keys) {
  for (const std::string& key : keys) m_names.emplace(key, short_name(key));
  std::map<std::string, int> count;
  for (const auto& [key, name] : m_names) ++count[name];
  for (auto& [key, name] : m_names)
    if (count[name] > 1) name = key;
}

std::string Names::of(const std::string& key) const {
  const auto found = m_names.find(key);
  return found == m_names.end() ? key : found->second;
}

std::string Names::whole(const std::string& key) {
  const Row* row = find_row(key);
  return row == nullptr || row->symbol.empty() ? key : fmt::format("{} ({})", key, row->symbol);
}

std::string label_of(const std::vector<Setting>& settings, const Names& names, bool whole) {
  if (settings.empty()) return "all";
  std::string label;
  for (const Setting& s : settings) {
    std::string value = whole ? s.value : without_folder(s.value);
    std::erase(value, '"');
    label += fmt::format("{}{} {}", label.empty() ? "" : ", ", names.of(s.key), value);
  }
  return label;
}

} // namespace matrigrate::study
