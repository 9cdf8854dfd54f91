#pragma once

#include "simulation/workspace.hpp"
#include "state/state.hpp"

#include <functional>

namespace matrigrate {

/// Force by which a clamp holds or drives its particles in the last step [nN]: minus the sum of elastic, fluid, load
/// and drag forces on the clamped particles that `belongs` picks by their reference position. Read-only. Test:
/// tests/physics/reaction_test.cpp
Vec2 clamp_force(const State& s, const Parameters& p, const Workspace& w,
                 const std::function<bool(const Vec2&)>& belongs);

} // namespace matrigrate
