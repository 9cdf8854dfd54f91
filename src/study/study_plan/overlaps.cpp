#include "study_plan/conditions.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

namespace matrigrate::study {

namespace {

/// A section that varies parameters.
struct Varying {
  std::string_view name;
  std::vector<std::string> own; ///< keys that are no parameters
};

const std::array<Varying, 2>& varying_sections() {
  static const std::array<Varying, 2> all{{{"sweep", {}}, {"latin_hypercube", {"samples"}}}};
  return all;
}

/// Tells each parameter that is varied and set by a condition as well.
class ConditionCheck {
public:
  ConditionCheck(const std::vector<ConditionDraft>& conditions, FaultList& faults) : m_faults(faults) {
    for (const ConditionDraft& draft : conditions)
      for (const Named& named : draft.parameters) m_set.emplace(named.row->path, draft.condition.label);
  }

  bool needed() const { return !m_set.empty(); }

  void check(const Named& named) {
    const auto found =
        std::ranges::find_if(m_set, [&](const auto& one) { return overlap(one.first, named.row->path); });
    if (found == m_set.end()) return;
    m_faults.add(place_of(*named.node), named.row->path,
                 fmt::format("is also set by the condition \"{}\"; a condition must not set a factor", found->second));
  }

private:
  FaultList& m_faults;
  std::map<std::string_view, std::string> m_set; ///< first condition that sets a parameter
};

} // namespace

void check_overlaps(const toml::table& study, const std::vector<ConditionDraft>& conditions, const Parameters& base,
                    FaultList& faults) {
  ConditionCheck condition_check(conditions, faults);
  FaultList told(""); // elsewhere
  for (const Varying& section : varying_sections()) {
    const toml::node* node = study.get(section.name);
    if (node == nullptr || !node->is_table()) continue;
    for (const Named& named : named_parameters(*node->as_table(), section.name, section.own, base, told))
      condition_check.check(named);
  }
  const toml::node* points = study.get("points");
  if (!condition_check.needed() || points == nullptr || !points->is_array()) return;
  for (const toml::node& point : *points->as_array())
    if (const toml::table* table = point.as_table())
      for (const Named& named : named_parameters(*table, "points", {"label"}, base, told)) condition_check.check(named);
}

} // namespace matrigrate::study
