#include "study_plan/axes.hpp"

#include "parameters/schema.hpp"
#include "study_plan/names.hpp"

#include <algorithm>

namespace matrigrate::study {

namespace {

using Json = nlohmann::ordered_json;

/// A swept value: the number in the unit of its row, the word, or the formula or file of a field or law.
Json value_of(const Row& row, const Parameters& p) {
  std::string text = value_text(row, p);
  std::erase(text, '"');
  const Kind of = kind(row);
  if (of == Kind::field || of == Kind::law || of == Kind::constants) return text.empty() ? "none" : text;
  if (kind(row) == Kind::choice || kind(row) == Kind::boolean) return text;
  const units::Quantity q = units::parse_quantity(text);
  if (kind(row) != Kind::quantity) return std::stod(q.number);
  const double internal = units::to_internal(q.number, units::parse_unit(q.unit));
  return units::number_in(internal, units::parse_unit(row.unit));
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
  for (const std::string& key : keys) cells *= static_cast<double>(values_of(study, *find_row(key)).size());
  return cells <= 2.0 * static_cast<double>(study.points.size());
}

/// One axis with all factor sets, another one with the conditions.
Json label_axes(const Study& study) {
  const auto axis = [](const char* name, const char* meaning, const auto& all) {
    Json labels = Json::array();
    for (const auto& one : all) labels.push_back(one.label);
    return Json{{"name", name}, {"label", name}, {"meaning", meaning}, {"unit", ""}, {"values", labels}};
  };
  if (study.conditions.empty()) return Json::array({axis("point", "Point of the study", study.sets)});
  return Json::array({axis("factors", "Factor set of the study", study.sets),
                      axis("condition", "Condition of the study", study.conditions)});
}

} // namespace

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
    const Row& row = *find_row(key);
    const std::vector<Json> values = values_of(study, row);
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i].push_back(std::ranges::find(values, value_of(row, study.points[i].parameters)) - values.begin());
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].empty()) all[i].push_back(i);
  return all;
}

Json axes_json(const Study& study) {
  if (!is_grid(study)) return label_axes(study);
  Json axes = Json::array();
  const Names names(study);
  for (const std::string& key : swept_keys(study)) {
    const Row& row = *find_row(key);
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
