#include "study_plan/conditions.hpp"

#include "parameters/assign.hpp"
#include "parameters/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace matrigrate::study {

namespace {

std::string label_in(const toml::table& table, FaultList& faults) {
  const toml::node* node =
      faults.wanted(table, "conditions", "label", "; write label = \"soft\", the name for targets");
  if (node == nullptr) return {};
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
    const toml::table* table = faults.table(node, "conditions", "table of parameters");
    if (table == nullptr) continue;
    ConditionDraft& draft = all.emplace_back(ConditionDraft{{label_in(*table, faults), {}}, place_of(node), {}});
    for (const Named& named : named_parameters(*table, "conditions", "label", base, faults)) {
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

void check_overlaps(const toml::table& study, const std::vector<ConditionDraft>& conditions, const Parameters& base,
                    FaultList& faults) {
  std::map<std::string_view, std::string> set; // the first condition that sets a parameter
  for (const ConditionDraft& draft : conditions)
    for (const Named& named : draft.parameters) set.emplace(named.row->path, draft.condition.label);
  if (set.empty()) return;
  FaultList told(""); // elsewhere
  const auto check = [&](const toml::node* node, std::string_view section, std::string_view own) {
    if (node == nullptr || !node->is_table()) return;
    for (const Named& named : named_parameters(*node->as_table(), section, own, base, told)) {
      const auto found =
          std::ranges::find_if(set, [&](const auto& one) { return overlap(one.first, named.row->path); });
      if (found != set.end())
        faults.add(
            place_of(*named.node), named.row->path,
            fmt::format("is also set by the condition \"{}\"; a condition must not set a factor", found->second));
    }
  };
  check(study.get("sweep"), "sweep", {});
  check(study.get("latin_hypercube"), "latin_hypercube", "samples");
  if (const toml::array* points = study["points"].as_array())
    for (const toml::node& point : *points) check(&point, "points", "label");
}

} // namespace matrigrate::study
