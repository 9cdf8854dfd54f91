#pragma once

#include "simulation/workspace.hpp"

namespace matrigrate {

/// Advances positions, density and stress by dt with the velocities of the state (ecm/loop/stress or
/// ecm/loop/updated_lagrangian). Growing protrusions spread, and anchors move with the matrix. The total-Lagrangian
/// form uses the change of F over the step, the updated-Lagrangian one the velocity gradient at its start. Test:
/// tests/physics/advance_test.cpp
void move(State& s, const Parameters& p, double dt, Workspace& w);

} // namespace matrigrate
