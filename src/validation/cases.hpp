#pragma once

#include "parameters/parameters.hpp"
#include "validation/case.hpp"

/// The cases themselves, a file each. Geometry and loads are a case's own; material and numerics come from the
/// parameters.
namespace matrigrate::validation {

Result patch(const Parameters& p);
Result rigid(const Parameters& p);
Result stretch(const Parameters& p);
Result creep(const Parameters& p);
Result relaxation(const Parameters& p);
Result point_force(const Parameters& p);
Result load(const Parameters& p);
Result poiseuille(const Parameters& p);
Result tearing(const Parameters& p);
Result convergence(const Parameters& p);
Result step_limit(const Parameters& p);
Result fibres(const Parameters& p);
Result fibres_uniaxial(const Parameters& p);
Result protrusion(const Parameters& p);
Result maturation(const Parameters& p);
Result time_step(const Parameters& p);
Result disassembly(const Parameters& p);
Result initiation(const Parameters& p);
Result handover(const Parameters& p);
Result follow(const Parameters& p);
Result fibre_maturation(const Parameters& p);
Result competition(const Parameters& p);
Result stunting(const Parameters& p);

/// Plots of cases from their tables alone, so that they can be made of kept tables.
/// @throws InputOutputError if the table has not the columns of the case
report::Plot plot_fibres(const store::Table& table);
report::Plot plot_fibres_uniaxial(const store::Table& table);
report::Plot plot_disassembly(const store::Table& table);

} // namespace matrigrate::validation
