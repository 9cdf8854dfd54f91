#include "simulation/start.hpp"

#include "base/failure.hpp"
#include "cell/nucleus.hpp"
#include "ecm/bonds.hpp"
#include "ecm/law/fibre_table.hpp"
#include "parameters/laws/law.hpp"
#include "simulation/start_fields.hpp"
#include "simulation/step_limits.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace matrigrate {

State initial_state(const Parameters& p) {
  State s;
  s.ecm = disc(p);
  apply(matrix_fields(p), s.ecm);
  for (const CellStart& start : cell_starts(p)) {
    const auto id = static_cast<std::uint32_t>(s.cells.size());
    Cell& cell = s.cells.emplace_back();
    cell.id = id;
    cell.cortex = round_cortex(p.cell, start);
    cell.nucleus = round_nucleus(p, start);
  }
  return s;
}

namespace {

/// The first fault of any field.
std::string fault_of_fields(const Parameters& p) {
  for (const Row& row : schema())
    if (kind(row) == Kind::field)
      if (std::string fault = fault_of_field(p, row); !fault.empty()) return fault;
  return {};
}

std::string fault_of_fibre_table(const Parameters& p) {
  try {
    (void)fibre_table(p);
  } catch (const std::invalid_argument& error) {
    return error.what();
  } catch (const NumericalFailure& error) {
    return error.what();
  }
  return {};
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
  if (!fault_of_fields(p).empty()) return {}; // said of each, but of a branch, which needs no files of fields
  const Parameters stiffest = as_stiff_everywhere(p);
  return fault_of_step(stiffest, step_limits(stiffest));
}

constexpr const char* tabulated = "the law of fibres can be tabulated";

std::vector<Rule> of_laws() {
  std::vector<Rule> rules = rules_of_law_values();
  const Row& fibres = *find_row("laws.fibre_stiffness");
  rules.push_back({tabulated, keys_of_law(fibres), fault_of_fibre_table, {values_rule(fibres)}, has_fibre_table, true});
  return rules;
}

/// The rules on laws and fields, and after them those that compute on the lattice.
std::vector<Rule> with_fields_and_laws(std::vector<Rule> on_lattice) {
  std::vector<Rule> rules = of_laws();
  for (const Row& row : schema())
    if (kind(row) == Kind::field)
      rules.push_back({values_rule(row),
                       {row.path},
                       [&row](const Parameters& p) {
                         const std::string fault = fault_of_field(p, row);
                         return fault.empty() ? fault_of_chained_field(p, row) : fault;
                       },
                       lattice_rules()});
  for (Rule& rule : on_lattice) {
    for (const std::string& name : lattice_rules()) rule.after.push_back(name);
    rules.push_back(std::move(rule));
  }
  return rules;
}

} // namespace

std::span<const Rule> formula_rules() {
  static const std::vector<Rule> all = [] {
    std::vector<Rule> rules = of_laws();
    for (const Row& row : schema())
      if (kind(row) == Kind::field)
        rules.push_back(
            {values_rule(row), {row.path}, [&row](const Parameters& p) { return fault_of_chained_field(p, row); }});
    return rules;
  }();
  return all;
}

std::span<const Rule> start_rules() {
  static const std::vector<Rule> all = with_fields_and_laws({
      {"the step is stable",
       of_the_step(),
       fault_of_stability,
       {},
       [](const Parameters& p) { return !has_fibre_table(p); }},
      {"the step is stable with the law of fibres",
       of_the_step_and_law(),
       fault_of_stability,
       {tabulated},
       has_fibre_table},
      {"obstacles are clear of the cell",
       {"ecm.fields.obstacle", "cell.start_x", "cell.start_y", "cell.radius", "degradation.body_distance"},
       fault_of_obstacles},
      {"fibres lie on bonds",
       {"fibres.direction_deg", "fibres.half_angle_deg", "fibres.arrangement", "ecm.lattice", "ecm.smoothing_length",
        "ecm.particle_spacing"},
       [](const Parameters& p) { return p.fibres.field.direction_deg.empty() ? fault_of_fibres(p) : std::string(); }},
  });
  return all;
}

} // namespace matrigrate
