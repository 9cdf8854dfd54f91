#include "study_plan/names.hpp"

#include "parameters/laws/constants.hpp"
#include "parameters/schema.hpp"
#include "parameters/units.hpp"
#include "study_plan/settings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::study {

namespace {

using Json = nlohmann::ordered_json;

/// The last word of a path, or the paper's letters.
std::string short_name(const std::string& key) {
  const Row* row = find_row(key);
  if (row != nullptr && key_of(*row) == "number") return std::string(row->symbol);
  return key.substr(key.rfind('.') + 1);
}

std::string set_text(const Study& study, std::size_t set) {
  const FactorSet& one = study.sets[set];
  if (!one.label.starts_with("sample ") || one.settings.empty()) return one.label;
  std::vector<Setting> rounded = one.settings;
  for (Setting& s : rounded) {
    if (kind(*find_row(s.key, study.base)) != Kind::quantity) continue;
    std::string bare = s.value;
    std::erase(bare, '"');
    const units::Quantity quantity = units::parse_quantity(bare);
    s.value = fmt::format("{:g} {}", std::stod(fmt::format("{:.3g}", std::stod(quantity.number))), quantity.unit);
  }
  return label_of(rounded, Names(study));
}

/// A swept value: the number in the unit of its row, the word, or the formula or file of a field or law.
Json value_of(const Row& row, const Parameters& p) {
  const std::string text = swept_text(row, p);
  const Kind of = kind(row);
  if (of == Kind::field || of == Kind::law || of == Kind::constants) return text.empty() ? "none" : text;
  if (of == Kind::choice || of == Kind::boolean) return text;
  return std::stod(text);
}

/// The values of a parameter over all points, each once.
std::vector<Json> values_of(const Study& study, const Row& row) {
  std::vector<Json> values;
  for (const Point& point : study.points) {
    const Json value = value_of(row, point.parameters);
    if (std::ranges::find(values, value) == values.end()) values.push_back(value);
  }
  if (!values.empty() && values.front().is_number())
    std::ranges::sort(values, [](const Json& a, const Json& b) { return a.get<double>() < b.get<double>(); });
  return values;
}

/// Whether the points fill the grid of the values of their parameters, or nearly so: of a design that screens factors,
/// or of a Latin hypercube, the grid would be as good as empty, and beyond any page.
bool is_grid(const Study& study) {
  const std::vector<std::string> keys = swept_keys(study);
  if (keys.empty()) return false;
  double cells = 1.0;
  for (const std::string& key : keys) cells *= static_cast<double>(values_of(study, *find_row(key, study.base)).size());
  return cells <= 2.0 * static_cast<double>(study.points.size());
}

/// One axis with all factor sets, another one with the conditions.
Json label_axes(const Study& study) {
  const auto axis = [](const char* name, const char* meaning, const auto& all) {
    return Json{{"name", name}, {"label", name}, {"meaning", meaning}, {"unit", ""}, {"values", all_labels(all)}};
  };
  if (study.conditions.empty()) return Json::array({axis("point", "Point of the study", study.sets)});
  return Json::array({axis("factors", "Factor set of the study", study.sets),
                      axis("condition", "Condition of the study", study.conditions)});
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
  if (const std::string_view constant = constant_name(key); !constant.empty()) return std::string(constant);
  const Row* row = find_row(key);
  return row == nullptr || row->symbol.empty() ? key : fmt::format("{} ({})", key, row->symbol);
}

std::string swept_text(const Row& row, const Parameters& p) {
  std::string text = meaning_text(row, p);
  std::erase(text, '"');
  if (kind(row) != Kind::quantity) return text;
  const auto quantity = units::parse_quantity(text);
  if (quantity.unit == row.unit) return quantity.number;
  const double internal = units::to_internal(quantity.number, units::parse_unit(quantity.unit));
  return fmt::format("{}", units::number_in(internal, units::parse_unit(row.unit)));
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

std::string point_text(const Study& study, std::size_t point) {
  const Point& one = study.points[point];
  const std::string text = set_text(study, one.set);
  if (text == study.sets[one.set].label) return one.label;
  return study.conditions.empty() ? text : fmt::format("{}: {}", study.conditions[one.condition].label, text);
}

std::vector<Json> places(const Study& study) {
  std::vector<Json> all(study.points.size(), Json::array());
  if (!is_grid(study)) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].push_back(study.points[i].set);
      if (!study.conditions.empty()) all[i].push_back(study.points[i].condition);
    }
    return all;
  }
  for (const std::string& key : swept_keys(study)) {
    const Row& row = *find_row(key, study.base);
    const std::vector<Json> values = values_of(study, row);
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i].push_back(std::ranges::find(values, value_of(row, study.points[i].parameters)) - values.begin());
  }
  return all;
}

Json axes_json(const Study& study) {
  if (!is_grid(study)) return label_axes(study);
  Json axes = Json::array();
  const Names names(study);
  for (const std::string& key : swept_keys(study)) {
    const Row& row = *find_row(key, study.base);
    const std::string label = row.symbol.empty() ? names.of(key) : std::string(row.symbol);
    axes.push_back({{"name", key},
                    {"label", label},
                    {"meaning", row.description},
                    {"unit", row.unit == "1" ? "" : row.unit},
                    {"values", values_of(study, row)}});
  }
  return axes;
}

} // namespace matrigrate::study
