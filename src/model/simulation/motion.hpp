#pragma once

#include "simulation/workspace.hpp"

namespace matrigrate {

/// Advances positions, density and stress by dt with the velocities of the state (ecm/loop/stress), the stress by
/// the change of F over the step. Growing protrusions spread, and anchors move with the matrix. Test:
/// tests/physics/advance_test.cpp
void move(State& s, const Parameters& p, double dt, Workspace& w);

} // namespace matrigrate
