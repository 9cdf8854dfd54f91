#include "study_plan/settings.hpp"

#include "parameters/gone.hpp"
#include "parameters/schema.hpp"

#include <set>

namespace matrigrate::study {

namespace {

/// The value that a point, or else its scenario, gives a parameter that has gone; the one that is left if neither does.
std::string value_in(const Gone& parameter, const toml::table& point, const toml::table& scenario) {
  if (const toml::node* node = point.get(parameter.path)) return gone_value(*node);
  const auto node = scenario.at_path(parameter.path);
  return node ? gone_value(*node.node()) : std::string(parameter.left);
}

/// The formula of a law with the values of a point; nothing if a value is none that any version knew.
std::optional<std::string> formula_of(std::string_view law, const toml::table& point, const toml::table& scenario) {
  std::string formula;
  for (const Gone& parameter : gone()) {
    if (parameter.law != law) continue;
    const std::string value = value_in(parameter, point, scenario);
    if (value == parameter.left) continue;
    const auto one = formula_of_gone(parameter, value);
    if (!one) return std::nullopt;
    formula += (formula.empty() ? "" : "*") + *one;
  }
  return formula.empty() ? std::string(*find_row(law)->before) : formula;
}

void say_by_laws(toml::table& point, const toml::table& scenario) {
  std::set<std::string_view> laws;
  for (const Gone& parameter : gone())
    if (!parameter.law.empty() && point.contains(parameter.path)) laws.insert(parameter.law);
  for (const std::string_view law : laws) {
    const auto formula = formula_of(law, point, scenario);
    if (!formula) continue; // the value is refused
    for (const Gone& parameter : gone())
      if (parameter.law == law) point.erase(parameter.path);
    point.insert(law, *formula);
  }
}

} // namespace

bool is_written_out(std::string_view text) { return text.starts_with("# A study with all its points written out"); }

GoneValues follow_gone(toml::table& study, const toml::table& scenario) {
  GoneValues said;
  for (const std::string_view key : {"points", "conditions"}) {
    toml::array* list = study[key].as_array();
    if (list == nullptr) continue;
    list->for_each([&](toml::table& point) {
      if (key == "points")
        for (const Gone& parameter : gone())
          if (const toml::node* value = point.get(parameter.path))
            said[Place(point)].emplace(parameter.path, gone_value(*value));
      say_by_laws(point, scenario);
      if (key == "points")
        for (const Gone& parameter : gone())
          if (parameter.law.empty()) point.erase(parameter.path);
    });
  }
  return said;
}

} // namespace matrigrate::study
