#include "study/conditions.hpp"
#include "study/design/designs.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

namespace matrigrate::study {

namespace {

/// A section that varies parameters.
struct Varying {
  std::string_view name;
  std::vector<std::string> own; ///< keys that are no parameters
  bool effects;                 ///< gives each factor an effect, so that nothing else may vary it
};

const std::array<Varying, 4>& varying_sections() {
  static const std::array<Varying, 4> all{{{"sweep", {}, false},
                                           {"one_at_a_time", {}, true},
                                           {"morris", {"trajectories", "levels"}, true},
                                           {"latin_hypercube", {"samples"}, false}}};
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
    const auto found = m_set.find(named.row->path);
    if (found == m_set.end()) return;
    m_faults.add(place_of(*named.node), named.row->path,
                 fmt::format("is also set by the condition \"{}\"; a condition must not set a factor", found->second));
  }

private:
  FaultList& m_faults;
  std::map<std::string_view, std::string> m_set; ///< first condition that sets a parameter
};

} // namespace

void check_overlaps(const toml::table& study, const std::vector<ConditionDraft>& conditions, FaultList& faults) {
  ConditionCheck condition_check(conditions, faults);
  FaultList told("");                                   // elsewhere
  std::map<std::string_view, const Varying*> varied_by; // the first section that varies a parameter
  for (const Varying& section : varying_sections()) {
    const toml::node* node = study.get(section.name);
    if (node == nullptr || !node->is_table()) continue;
    for (const Named& named : named_parameters(*node->as_table(), section.name, section.own, told)) {
      condition_check.check(named);
      const auto [first, is_new] = varied_by.try_emplace(named.row->path, &section);
      if (is_new || !(section.effects || first->second->effects)) continue;
      faults.add(place_of(*named.node), named.row->path,
                 fmt::format("stands in two designs, [{}] and [{}]", first->second->name, section.name));
    }
  }
  const toml::node* points = study.get("points");
  if (!condition_check.needed() || points == nullptr || !points->is_array()) return;
  for (const toml::node& point : *points->as_array())
    if (const toml::table* table = point.as_table())
      for (const Named& named : named_parameters(*table, "points", {"label"}, told)) condition_check.check(named);
}

} // namespace matrigrate::study
