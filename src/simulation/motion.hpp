#pragma once

#include "simulation/workspace.hpp"

namespace matrigrate {

/// Positions, density and stress after dt with the velocities of the state (ecm/stress or ecm/updated_lagrangian), and
/// what moves with them: growing protrusions spread, anchors are carried along. Reference neighbours give the change of
/// F over the step, current ones its rate at the start. Test: tests/physics/advance_test.cpp
void move(State& s, const Parameters& p, double dt, Workspace& w);

} // namespace matrigrate
