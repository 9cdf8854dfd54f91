#pragma once

#include "simulation/workspace.hpp"
#include "state/state.hpp"

#include <functional>

namespace matrigrate {

/// Force by which a clamp holds or drives its particles [nN]: minus the sum of elastic, fluid, fibre and load forces of
/// the last step, taken at the positions before it, and of the pair drag (Eq. 2) of its velocities, taken at the
/// positions after it, on the clamped particles that `belongs` picks by their reference position. The implicit drag of
/// stiffened fibres (MODEL.md, I26) and that of the cell are left out. Read-only. Test: tests/physics/reaction_test.cpp
Vec2 clamp_force(const State& s, const Parameters& p, const Workspace& w,
                 const std::function<bool(const Vec2&)>& belongs);

} // namespace matrigrate
