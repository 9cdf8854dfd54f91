#include "parameters/node.hpp"
#include "study/design/designs.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::study {

namespace {

/// Takes the base's own value off a list.
void leave_out_base(ValueList& list, const Parameters& base) {
  const std::string own = value_text(*list.row, base);
  for (std::size_t k = list.settings.size(); k-- > 0;) {
    if (list.settings[k].value != own) continue;
    list.settings.erase(list.settings.begin() + static_cast<std::ptrdiff_t>(k));
    list.nodes.erase(list.nodes.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

} // namespace

Designed one_at_a_time_sets(const toml::table& lists, const Parameters& base, Allowance& allowance, FaultList& faults) {
  Designed made;
  std::vector<ValueList> all = value_lists(lists, "one_at_a_time", base, faults);
  if (all.empty() && faults.empty())
    faults.add(place_of(lists), "one_at_a_time", "has no list of values of a parameter");
  std::size_t count = 1;
  for (ValueList& list : all) {
    const Place place = place_of(*list.nodes.front());
    leave_out_base(list, base);
    count += list.settings.size();
    if (list.settings.empty())
      faults.add(place, list.row->path,
                 fmt::format("has no other value than that of the base, {}", value_text(*list.row, base)));
  }
  if (all.empty() || !allowance.allows(static_cast<double>(count), place_of(lists), "one_at_a_time", faults))
    return made;
  made.drafts.push_back({{.label = std::string(base_label), .settings = {}, .parameters = base}, place_of(lists), {}});
  for (const ValueList& list : all)
    for (std::size_t k = 0; k < list.settings.size(); ++k) {
      Draft draft{{.label = {}, .settings = {list.settings[k]}, .parameters = base},
                  place_of(*list.nodes[k]),
                  {{std::string(list.row->path), place_of(*list.nodes[k])}}};
      assign(*list.row, given_by(*list.nodes[k]), draft.point.parameters);
      made.steps.push_back({.design = Design::one_at_a_time,
                            .factor = std::string(list.row->path),
                            .from = 0,
                            .to = made.drafts.size()});
      made.drafts.push_back(std::move(draft));
    }
  return made;
}

} // namespace matrigrate::study
