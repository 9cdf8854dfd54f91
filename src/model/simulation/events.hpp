#pragma once

#include "simulation/workspace.hpp"

#include <span>

/// Events at the end of a step of dt [s], after the motion of cell and matrix. Test:
/// tests/physics/migration_test.cpp
namespace matrigrate {

/// Degradation around tips, protrusions and body of each cell, among the particles near it at the start of the step;
/// where several cells degrade a particle, their rates add. Solid particles deep inside a cell become fluid
/// (contact/degrade). Tips act from their positions in the middle of the step (MODEL.md, I15).
void degrade_around_cells(State& s, const Parameters& p, double dt, Workspace& w);

/// Diffusion, decay and uptake of the chemoattractant (cues), where it diffuses.
void advance_attractant(State& s, const Parameters& p, double dt, Workspace& w);

/// Deflection, transitions, polarization, initiation, and the ratchet of rest lengths of a cell (protrusion,
/// cell/rest_length). Cues say where protrusions begin (cues/sensing).
/// @param now    the end of the step
/// @param given  factor on the initiation of each particle of the cortex from outside (Workspace::propensity); empty: 1
///               for all [-]
/// @return whether laws.initiation_bias is 0 along the whole cortex, so that protrusions begin as without it
bool advance_protrusions(Cell& cell, const EcmState& ecm, const Instant& now, const Parameters& p, double dt,
                         const Laws& laws, std::span<const double> given = {});

/// @throws NumericalFailure if a cell is too near the rim of the matrix (MODEL.md, I22)
void require_inside(const State& s, const Parameters& p);

} // namespace matrigrate
