#include "simulation/start_rules.hpp"

#include "base/failure.hpp"
#include "ecm/bonds.hpp"
#include "ecm/law/fibre_table.hpp"
#include "parameters/laws/law.hpp"
#include "simulation/start_fields.hpp"
#include "simulation/step_limits.hpp"

#include <stdexcept>
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

/// What the values of a law may depend on.
std::vector<std::string_view> keys_of_law(const Row& law) {
  std::vector<std::string_view> keys{law.path, "laws.constants"};
  for (const Row& row : schema())
    if (!row.symbol.empty() && section_of(row) != "run") keys.push_back(row.path);
  return keys;
}

std::string fault_of_fibre_table(const Parameters& p) {
  const Row& law = *find_row("laws.fibre_stiffness");
  if (!fault_of_constants(p).empty() || !fault_of_law(p, law).empty() || !fault_of_law_values(p, law).empty())
    return {}; // said already
  try {
    (void)fibre_table(p);
  } catch (const std::invalid_argument& error) {
    return error.what();
  } catch (const NumericalFailure& error) {
    return error.what();
  }
  return {};
}

bool has_bad_fibres(const Parameters& p) {
  const Row& law = *find_row("laws.fibre_stiffness");
  return is_changed(law, p)
         && (!fault_of_constants(p).empty() || !fault_of_law(p, law).empty() || !fault_of_law_values(p, law).empty()
             || !fault_of_fibre_table(p).empty());
}

/// What the longest stable step depends on.
std::vector<std::string_view> of_the_step() {
  return {"run.time_step",        "run.integrator",       "ecm.youngs_modulus",    "ecm.fields.youngs_modulus",
          "ecm.poissons_ratio",   "ecm.viscosity",        "fibres.stiffness",      "fibres.field.stiffness",
          "fibres.arrangement",   "fibres.direction_deg", "fibres.half_angle_deg", "ecm.particle_spacing",
          "ecm.smoothing_length", "ecm.lattice",          "ecm.hourglass_weight",  "ecm.thickness"};
}

std::vector<std::string_view> of_the_step_and_law() {
  std::vector<std::string_view> keys = of_the_step();
  for (const std::string_view key : keys_of_law(*find_row("laws.fibre_stiffness")))
    if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  return keys;
}

std::string fault_of_stability(const Parameters& p) {
  if (!fault_of_fields(p).empty() || has_bad_fibres(p)) return {}; // said below
  const Parameters stiffest = as_stiff_everywhere(p);
  return fault_of_step(stiffest, step_limits(stiffest));
}

/// One for each law: its values are allowed.
std::vector<Rule> of_laws() {
  std::vector<Rule> rules;
  for (const Row& law : law_rows())
    if (kind(law) == Kind::law)
      rules.push_back({"the values of a law are allowed", keys_of_law(law),
                       [&law](const Parameters& p) { return fault_of_law_values(p, law); },
                       [&law](const Parameters& p) { return is_changed(law, p); }, true});
  const Row& fibres = *find_row("laws.fibre_stiffness");
  rules.push_back({"the law of fibres can be tabulated", keys_of_law(fibres), fault_of_fibre_table,
                   [&fibres](const Parameters& p) { return is_changed(fibres, p); }, true});
  return rules;
}

/// The rules, and one for each field and law: its values are allowed.
std::vector<Rule> with_fields_and_laws(std::vector<Rule> rules) {
  for (const Rule& rule : of_laws()) rules.push_back(rule);
  for (const Row& row : schema())
    if (kind(row) == Kind::field)
      rules.push_back({"the values of a field are allowed", {row.path}, [&row](const Parameters& p) {
                         const std::string fault = fault_of_field(p, row);
                         return fault.empty() ? fault_of_chained_field(p, row) : fault;
                       }});
  return rules;
}

} // namespace

std::span<const Rule> law_rules() {
  static const std::vector<Rule> all = of_possible_lattices(of_laws());
  return all;
}

std::span<const Rule> start_rules() {
  static const std::vector<Rule> all = of_possible_lattices(with_fields_and_laws({
      {"the step is stable", of_the_step(), fault_of_stability,
       [](const Parameters& p) { return !is_changed(*find_row("laws.fibre_stiffness"), p); }},
      {"the step is stable with the law of fibres", of_the_step_and_law(), fault_of_stability,
       [](const Parameters& p) { return is_changed(*find_row("laws.fibre_stiffness"), p); }},
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
