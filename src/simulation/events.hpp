#pragma once

#include "simulation/workspace.hpp"

#include <span>

/// Events at the end of a step of dt [s], after the motion of cell and matrix. Test:
/// tests/physics/migration_test.cpp
namespace matrigrate {

/// Degradation around tips, protrusions and body of each cell, among the particles near it at the start of the step;
/// where several cells degrade a particle, their rates add. Solid particles deep inside a cell become fluid
/// (contact/degrade). Tips act from their positions in the middle of the step (MODEL.md, D15).
void degrade_around_cells(State& s, const Parameters& p, double dt, Workspace& w);

/// Deflection, transitions, polarization, initiation, and the ratchet of rest lengths of a cell (protrusion,
/// cell/rest_length).   @param now  the end of the step   @param propensity  of initiation, of each particle of the
/// cortex (Workspace::propensity); empty: 1 for all [-]
void advance_protrusions(Cell& cell, const EcmState& ecm, const Instant& now, const Parameters& p, double dt,
                         std::span<const double> propensity = {});

/// @throws NumericalFailure if a cell is too near the rim of the matrix (MODEL.md, D22)
void require_inside(const State& s, const Parameters& p);

} // namespace matrigrate
