#pragma once

#include "simulation/simulation.hpp"

/// Small helpers that the cases share.
namespace matrigrate::validation {

/// A uniform body force on all free particles. @param b  force per volume [nN/um^3]
Loads body_force(const Parameters& p, const Vec2& b);

/// Moves the clamped particles by u(X) at a constant speed, then holds them. The stress follows from rates, so a
/// displacement must be driven; a jump would leave none.
void drive_clamped(Simulation& a, const std::function<Vec2(const Vec2&)>& u, double seconds, const Loads& loads = {});

/// Mean displacement of the free particles no further than half a row from y = 0 [um].
Vec2 mid_displacement(const EcmState& ecm, const EcmParameters& p);

/// Distance between the innermost clamped rows of a strip [um]: the walls, known to within a spacing.
double wall_distance(const EcmState& ecm);

} // namespace matrigrate::validation
