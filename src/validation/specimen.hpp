#pragma once

#include "parameters/parameters.hpp"
#include "simulation/march.hpp"
#include "state/state.hpp"

/// Small helpers that the cases share.
namespace matrigrate::validation {

/// A state, its parameters and workspace, ready to march.
struct Specimen {
  Specimen(EcmState ecm, const Parameters& parameters);
  Specimen(State state, const Parameters& parameters);

  void march_for(double seconds, const Loads& loads = {}, const std::function<bool(const State&)>& each_step = {});

  Parameters p;
  State s;
  Workspace w;
};

/// A uniform body force on all free particles. @param b  force per volume [nN/um^3]
Loads body_force(const Parameters& p, const Vec2& b);

/// Moves the clamped particles by u(X) at a constant speed, then holds them. The stress follows from rates, so a
/// displacement must be driven; a jump would leave none.
void drive_clamped(Specimen& a, const std::function<Vec2(const Vec2&)>& u, double seconds, const Loads& loads = {});

/// Mean displacement of the free particles no further than half a row from y = 0 [um].
Vec2 mid_displacement(const EcmState& ecm, const EcmParameters& p);

/// Distance between the innermost clamped rows of a strip [um]: the walls, known to within a spacing.
double wall_distance(const EcmState& ecm);

} // namespace matrigrate::validation
