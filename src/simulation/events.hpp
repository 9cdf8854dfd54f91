#pragma once

#include "simulation/workspace.hpp"

/// Events at the end of a step of dt [s], after the motion of cell and matrix. Test:
/// tests/physics/migration_test.cpp
namespace matrigrate {

/// Degradation around tips, protrusions and body, among the particles near the cell at the start of the step. Solid
/// particles deep inside the cell become fluid (contact/degrade). Tips act from their positions in the middle of the
/// step (MODEL.md, D15).
void degrade_around_cell(State& s, const Parameters& p, double dt, Workspace& w);

/// Deflection, transitions, polarization, initiation, and the ratchet of rest lengths (protrusion, cell/rest_length).
void advance_protrusions(State& s, const Parameters& p, double dt);

/// @throws NumericalFailure if the cell is too near the rim of the matrix (MODEL.md, D22)
void require_inside(const State& s, const Parameters& p);

} // namespace matrigrate
