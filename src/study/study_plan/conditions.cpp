#include "study_plan/conditions.hpp"

#include "parameters/assign.hpp"
#include "parameters/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace matrigrate::study {

namespace {

std::string label_in(const toml::table& table, FaultList& faults) {
  const toml::node* node = table.get("label");
  if (node == nullptr) {
    faults.add(place_of(table), "conditions.label", "is missing; write label = \"soft\", the name for targets");
    return {};
  }
  std::string label = faults.text(*node, "conditions.label");
  if (label.empty() && node->is_string()) faults.add(place_of(*node), "conditions.label", "is empty");
  return label;
}

void check_twins(const std::vector<ConditionDraft>& all, const Parameters& base, FaultList& faults) {
  std::map<std::string, int> labels;
  std::map<std::string, int> seen;
  for (const ConditionDraft& draft : all) {
    const std::string& label = draft.condition.label;
    if (!label.empty() && labels[label]++ > 0)
      faults.add(draft.place, "conditions", fmt::format("\"{}\" is the label of two conditions", excerpt(label)));
    Parameters p = base;
    for (const Named& named : draft.parameters) assign(*named.row, given_by(*named.node), p);
    std::string settings;
    for (const Setting& s : meant(draft.condition.settings, p)) settings += fmt::format("{} = {}\n", s.key, s.value);
    if (seen[settings]++ > 0)
      faults.add(draft.place, "conditions", fmt::format("\"{}\": is the same as another condition", excerpt(label)));
  }
}

} // namespace

std::vector<ConditionDraft> read_conditions(const toml::array& list, const Parameters& base, FaultList& faults) {
  std::vector<ConditionDraft> all;
  if (list.size() > max_runs)
    faults.add(place_of(list), "conditions", fmt::format("has {} conditions; allowed are {}", list.size(), max_runs));
  if (list.size() > max_runs) return all;
  for (const toml::node& node : list) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      faults.add(place_of(node), "conditions",
                 fmt::format("is {}, but a table of parameters is expected", type_of(node)));
      continue;
    }
    ConditionDraft& draft = all.emplace_back(ConditionDraft{{label_in(*table, faults), {}}, place_of(node), {}});
    for (const Named& named : named_parameters(*table, "conditions", {"label"}, base, faults)) {
      Parameters scratch = base;
      auto setting = assigned(*named.row, *named.node, scratch, faults);
      if (!setting) continue;
      draft.condition.settings.push_back(std::move(*setting));
      draft.parameters.push_back(named);
    }
  }
  if (faults.empty()) check_twins(all, base, faults);
  return all;
}

std::vector<Draft> crossed(std::vector<Draft> sets, const std::vector<ConditionDraft>& conditions) {
  for (std::size_t i = 0; i < sets.size(); ++i) sets[i].point.set = i;
  if (conditions.empty()) return sets;
  std::vector<Draft> points;
  points.reserve(sets.size() * conditions.size());
  for (const Draft& set : sets)
    for (std::size_t c = 0; c < conditions.size(); ++c) {
      Draft& draft = points.emplace_back(set);
      draft.point.label = fmt::format("{}: {}", conditions[c].condition.label, set.point.label);
      draft.point.condition = c;
      const std::vector<Setting>& settings = conditions[c].condition.settings;
      draft.point.settings.insert(draft.point.settings.begin(), settings.begin(), settings.end());
      for (const Named& named : conditions[c].parameters) {
        assign(*named.row, given_by(*named.node), draft.point.parameters);
        draft.settings.emplace_back(named.row->path, place_of(*named.node));
      }
    }
  return points;
}

} // namespace matrigrate::study
