#include "simulation/start_rules.hpp"

#include "ecm/bonds.hpp"
#include "simulation/start_fields.hpp"
#include "simulation/step_limits.hpp"

#include <string>
#include <utility>
#include <vector>

namespace matrigrate {

namespace {

/// The first fault of any field.
std::string fault_of_fields(const Parameters& p) {
  for (const Row& row : schema())
    if (kind(row) == Kind::field)
      if (std::string fault = fault_of_field(p, row); !fault.empty()) return fault;
  return {};
}

/// The same rules for matrices that can be; rules() tell of others, and at once.
std::vector<Rule> of_possible_lattices(std::vector<Rule> all) {
  for (Rule& rule : all)
    rule.broken = [judge = std::move(rule.broken)](const Parameters& p) {
      return has_lattice(p) ? judge(p) : std::string();
    };
  return all;
}

/// The rules, and one for each field: its values are allowed.
std::vector<Rule> with_fields(std::vector<Rule> rules) {
  for (const Row& row : schema())
    if (kind(row) == Kind::field)
      rules.push_back({"the values of a field are allowed", {row.path}, [&row](const Parameters& p) {
                         return fault_of_field(p, row);
                       }});
  return rules;
}

} // namespace

std::span<const Rule> start_rules() {
  static const std::vector<Rule> all = of_possible_lattices(with_fields({
      {"the step is stable",
       {"run.time_step", "run.integrator", "ecm.youngs_modulus", "ecm.fields.youngs_modulus", "ecm.poissons_ratio",
        "ecm.viscosity", "fibres.stiffness", "fibres.field.stiffness", "fibres.arrangement", "fibres.direction_deg",
        "fibres.half_angle_deg", "ecm.particle_spacing", "ecm.smoothing_length", "ecm.lattice", "ecm.hourglass_weight",
        "ecm.thickness"},
       [](const Parameters& p) {
         if (!fault_of_fields(p).empty()) return std::string(); // said below
         const Parameters stiffest = as_stiff_everywhere(p);
         return fault_of_step(stiffest, step_limits(stiffest));
       }},
      {"obstacles are clear of the cell",
       {"ecm.fields.obstacle", "cell.start_x", "cell.start_y", "cell.radius", "degradation.body_distance"},
       fault_of_obstacles},
      {"fibres lie on bonds",
       {"fibres.direction_deg", "fibres.half_angle_deg", "fibres.arrangement", "ecm.lattice", "ecm.smoothing_length",
        "ecm.particle_spacing"},
       [](const Parameters& p) { return p.fibres.field.direction_deg.empty() ? fault_of_fibres(p) : std::string(); }},
  }));
  return all;
}

} // namespace matrigrate
