#pragma once

#include "parameters/parameters.hpp"

#include <string>

/// How large an explicit step may be, and what a longer one leaves open. Test:
/// tests/unit/simulation/step_limits_test.cpp, tests/physics/advance_test.cpp; measured by `validate step-limit`.
namespace matrigrate {

/// Largest stable steps of the explicit Euler update; the drag itself is implicit and sets none.
struct StepLimits {
  double elastic_s; ///< set by K, G and the hourglass penalty against mu [s]
  double fluid_s;   ///< set by K of the compressed fluid against mu [s]

  double smallest() const { return elastic_s < fluid_s ? elastic_s : fluid_s; }
  std::string binding() const; ///< which one is the smallest, in words
};

/// Von Neumann analysis of the discrete operators on an intact lattice. A plane wave of wave vector k decays at the
/// rates
///   eig[ t_z V_0 ((K + G/3) g g^T + G |g|^2 I) + c(k) I ] / d(k),
/// with g(k) the symbol of the corrected gradient, c(k) that of the hourglass penalty and d(k) that of the pair drag;
/// the limit is 2 over the largest rate over the Brillouin zone (for long waves about 2 mu/(K + 4G/3)). Depends on K,
/// G, mu, h/dp, the lattice and the penalty, not on dp itself. For the compressed fluid: rate t_z V_0 K |g_raw|^2 /
/// d(k).
StepLimits step_limits(const Parameters& p);

/// The adaptive integrator lets the matrix resist a change of its velocities with theta times its own drag, so that the
/// explicit forces bear longer steps: a mode of rate lambda then obeys
///   (1 + theta) z^2 - (1 + 2 theta - dt lambda) z + theta = 0,
/// which is stable for dt lambda < 2 + 4 theta. Of first order in dt, like the step itself; nothing changes at a
/// constant velocity (MODEL.md, D29).
/// @return theta = max(0, dt/(2 dt_0) - 0.4) with 1/dt_0 = 1/elastic_s + 1/fluid_s, a tenth more than stability asks
/// for;
///         0 for the reference integrator
double relaxation_theta(const Parameters& p, double dt, const StepLimits& limits);

/// How far a step of the adaptive integrator may move a particle, about what the recoil of a released protrusion moves
/// it in the paper's 0.4 s [particle spacings].
inline constexpr double usual_move = 0.2;

/// Relative residual at which a step's system counts as solved: solver.tolerance, and a hundred times it where the
/// adaptive integrator uses multigrid, whose error stays a hundred times below that of its steps (MODEL.md, D29) [-].
double solver_tolerance(const Parameters& p);

/// How far a particle may move before its drag is taken anew: ecm.drag_lag, with the adaptive integrator as many times
/// as its step dt is longer than the paper's 0.4 s (MODEL.md, D30) [um].
double drag_lag(const Parameters& p, double dt);

/// How often the adaptive integrator halves a step, at most.
inline constexpr int max_halvings = 7;

/// The shortest step that p.run.integrator takes [s].
double shortest_step(const Parameters& p);

/// The largest step that p.run.integrator takes; the adaptive one takes shorter ones than run.time_step where it has to
/// [s].
double largest_step(const Parameters& p, const StepLimits& limits);

/// run.time_step, halved until it is stable, as the longest steps of a run are [s].
double longest_step(const Parameters& p, const StepLimits& limits);

/// A step of two digits that is no longer than this one [s].
double rounded_down(double step);

/// Why run.time_step is too long, and a value that is not; empty if it is not too long, or if halves of it are not.
std::string fault_of_step(const Parameters& p, const StepLimits& limits);

/// @throws NumericalFailure if run.time_step is too long, with a value that is not
void require_stable_step(const Parameters& p);

/// The limits in one sentence.
std::string describe(const StepLimits& limits);

} // namespace matrigrate
