#include "study_plan/names.hpp"

#include "parameters/schema.hpp"
#include "parameters/units.hpp"
#include "study_plan/settings.hpp"

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

std::string set_text(const Study& study, std::size_t set) {
  const FactorSet& one = study.sets[set];
  if (!one.label.starts_with("sample ") || one.settings.empty()) return one.label;
  std::vector<Setting> rounded = one.settings;
  for (Setting& s : rounded) {
    if (kind(*find_row(s.key)) != Kind::quantity) continue;
    std::string bare = s.value;
    std::erase(bare, '"');
    const units::Quantity quantity = units::parse_quantity(bare);
    s.value = fmt::format("{:g} {}", std::stod(fmt::format("{:.3g}", std::stod(quantity.number))), quantity.unit);
  }
  return label_of(rounded, Names(study));
}

std::string point_text(const Study& study, std::size_t point) {
  const Point& one = study.points[point];
  const std::string text = set_text(study, one.set);
  if (text == study.sets[one.set].label) return one.label;
  return study.conditions.empty() ? text : fmt::format("{}: {}", study.conditions[one.condition].label, text);
}

} // namespace matrigrate::study
