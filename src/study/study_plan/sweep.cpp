#include "study_plan/sweep.hpp"

#include "parameters/assign.hpp"
#include "study_plan/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace matrigrate::study {

namespace {

/// A count as people write it, also beyond any integer.
std::string count_text(double count) {
  return count < 1e15 ? fmt::format("{:.0f}", count) : fmt::format("{:.2g}", count);
}

} // namespace

std::vector<ValueList> value_lists(const toml::table& table, std::string_view section, const Parameters& base,
                                   FaultList& faults) {
  std::vector<ValueList> all;
  for (const Named& named : named_parameters(table, section, {}, base, faults)) {
    const toml::array* list = named.node->as_array();
    if (list == nullptr || list->empty()) {
      faults.add(place_of(*named.node), named.row->path,
                 fmt::format("is {}, but a list of values is expected, such as [{}]",
                             list == nullptr ? type_of(*named.node) : "empty", value_text(*named.row, base)));
      continue;
    }
    if (list->size() > max_runs) {
      faults.add(place_of(*named.node), named.row->path,
                 fmt::format("has {} values; allowed are {}", list->size(), max_runs));
      continue;
    }
    ValueList& axis = all.emplace_back(ValueList{named.row, {}, {}});
    std::unordered_set<std::string> listed;
    for (const toml::node& value : *list) {
      Parameters scratch = base;
      const auto setting = assigned(*named.row, value, scratch, faults);
      if (!setting) continue;
      if (!listed.insert(meaning_text(*named.row, scratch)).second)
        faults.add(place_of(value), named.row->path, fmt::format("{} is listed twice", setting->value));
      axis.nodes.push_back(&value);
      axis.settings.push_back(*setting);
    }
    if (axis.settings.empty()) all.pop_back(); // all of them at fault
  }
  return all;
}

void name_sets(std::vector<Draft>& sets, const std::vector<Condition>& conditions) {
  std::unordered_set<std::string> keys;
  const auto take = [&](const std::vector<Setting>& settings) {
    for (const Setting& s : settings) keys.insert(s.key);
  };
  for (const Draft& draft : sets) take(draft.point.settings);
  for (const Condition& condition : conditions) take(condition.settings);
  const Names names({keys.begin(), keys.end()});
  std::vector<Draft*> unnamed;
  for (Draft& draft : sets)
    if (draft.point.label.empty()) unnamed.push_back(&draft);
  for (Draft* draft : unnamed) draft->point.label = label_of(draft->point.settings, names);
  std::unordered_map<std::string, int> count;
  for (const Draft& draft : sets) ++count[draft.point.label];
  for (Draft* draft : unnamed)
    if (count[draft->point.label] > 1) draft->point.label = label_of(draft->point.settings, names, true);
}

bool Allowance::allows(double more, Place place, std::string_view key, FaultList& faults) {
  m_points += more;
  const double points = m_points * static_cast<double>(std::max<std::size_t>(1, m_conditions));
  const double runs = points * static_cast<double>(m_replicates);
  if (runs <= static_cast<double>(max_runs)) return true;
  const std::string made = m_conditions > 0
                               ? fmt::format("{} factor sets; with {} conditions and {} replicates",
                                             count_text(m_points), m_conditions, m_replicates)
                               : fmt::format("{} points; with {} replicates", count_text(m_points), m_replicates);
  faults.add(place, key, fmt::format("makes {} these are {} runs; allowed are {}", made, count_text(runs), max_runs));
  return false;
}

std::vector<Draft> grid_points(const toml::table& sweep, const Parameters& base, Allowance& allowance,
                               FaultList& faults) {
  const std::vector<ValueList> all = value_lists(sweep, "sweep", base, faults);
  if (all.empty()) return {};
  double product = 1.0;
  for (const ValueList& axis : all) product *= static_cast<double>(axis.nodes.size());
  if (!allowance.allows(product, place_of(sweep), "sweep", faults)) return {};
  const auto count = static_cast<std::size_t>(product);
  std::vector<Draft> drafts(count);
  for (std::size_t i = 0; i < count; ++i) {
    Draft& draft = drafts[i];
    draft.point.parameters = base;
    std::size_t block = count;
    for (const ValueList& axis : all) {
      block /= axis.nodes.size();
      const std::size_t k = i / block % axis.nodes.size();
      assign(*axis.row, given_by(*axis.nodes[k]), draft.point.parameters);
      draft.point.settings.push_back(axis.settings[k]);
      draft.settings.emplace_back(axis.row->path, place_of(*axis.nodes[k]));
    }
    draft.place = draft.settings.front().second;
  }
  return drafts;
}

std::vector<Draft> listed_points(const toml::array& points, const Parameters& base, Allowance& allowance,
                                 FaultList& faults) {
  std::vector<Draft> drafts;
  if (!allowance.allows(static_cast<double>(points.size()), place_of(points), "points", faults)) return drafts;
  for (const toml::node& node : points) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      faults.add(place_of(node), "points", fmt::format("is {}, but a table of parameters is expected", type_of(node)));
      continue;
    }
    Draft draft;
    draft.place = place_of(node);
    draft.point.parameters = base;
    for (const Named& named : named_parameters(*table, "points", {"label"}, base, faults))
      if (auto setting = assigned(*named.row, *named.node, draft.point.parameters, faults)) {
        draft.point.settings.push_back(std::move(*setting));
        draft.settings.emplace_back(named.row->path, place_of(*named.node));
      }
    if (const toml::node* label = table->get("label")) draft.point.label = faults.text(*label, "points.label");
    drafts.push_back(std::move(draft));
  }
  return drafts;
}

} // namespace matrigrate::study
