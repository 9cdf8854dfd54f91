#pragma once

#include "simulation/workspace.hpp"

/// What happens to cell and matrix at the end of a step of dt [s], after they have moved. Test:
/// tests/physics/migration_test.cpp
namespace matrigrate {

/// Degradation around tips, protrusions and body, of the particles that were near at the start of the step; solid deep
/// inside the cell becomes fluid (contact/degrade). Tips act from where they are in the middle of the step: at its end
/// they would run ahead of their own degradation, the more the longer the step.
void degrade_around_cell(State& s, const Parameters& p, double dt, Workspace& w);

/// Deflection, transitions, polarization, initiation, and the ratchet of rest lengths (protrusion, cell/rest_length).
void advance_protrusions(State& s, const Parameters& p, double dt);

/// @throws NumericalFailure if the cell is too near the rim of the matrix (MODEL.md, D22)
void require_inside(const State& s, const Parameters& p);

} // namespace matrigrate
