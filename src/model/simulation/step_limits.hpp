#pragma once

#include "parameters/parameters.hpp"
#include "state/ecm.hpp"

#include <string>

/// Stability limits of the time step (explicit Euler, the counterpart of a CFL condition), and bounds of the adaptive
/// integrator. Test:
/// tests/unit/simulation/step_limits_test.cpp, tests/physics/advance_test.cpp; measured by `validate step-limit`.
namespace matrigrate {

/// Largest stable steps of the explicit Euler update; the drag itself is implicit and sets none.
struct StepLimits {
  double elastic_s; ///< set by K, G and the hourglass penalty against mu [s]
  double fluid_s;   ///< set by K of the compressed fluid against mu [s]

  double smallest() const { return elastic_s < fluid_s ? elastic_s : fluid_s; }
  std::string binding() const; ///< which of them is the smaller, in words
};

/// Von Neumann analysis of the discrete operators on an intact lattice. A plane wave of wave vector k decays at the
/// rates
///   eig[ t_z V_0 ((K + G/3) g g^T + G |g|^2 I) + c(k) I ] / d(k),
/// with g(k) the symbol of the corrected gradient, c(k) that of the hourglass penalty and d(k) that of the pair drag;
/// the limit is 2 over the largest rate over the Brillouin zone (for long waves about 2 mu/(K + 4G/3)). Depends on K,
/// G, mu, h/dp, the lattice and the penalty, not on dp itself. For the compressed fluid: rate t_z V_0 K |g_raw|^2 /
/// d(k).
StepLimits step_limits(const Parameters& p);

/// The same for a matrix that varies from place to place: as if its largest Young's modulus were everywhere, and as if
/// all neighbours were joined by fibres where their direction varies.
StepLimits step_limits(const Parameters& p, const EcmState& ecm);

/// The adaptive integrator adds a drag on changes of the matrix's velocities, theta times its own drag, so that longer
/// steps are stable. A mode of rate lambda then obeys
///   (1 + theta) z^2 - (1 + 2 theta - dt lambda) z + theta = 0,
/// which is stable for dt lambda < 2 + 4 theta. The term is of first order in dt, like the step itself, and vanishes at
/// constant velocity (MODEL.md, I29).
/// @return theta = max(0, dt/(2 dt_0) - 0.4) with 1/dt_0 = 1/elastic_s + 1/fluid_s, 0.1 more than stability requires; 0
///         for the reference integrator
double relaxation_theta(const Parameters& p, double dt, const StepLimits& limits);

/// Maximum displacement of a particle per step of the adaptive integrator [particle spacings]. The recoil of a released
/// protrusion moves a particle about this far in the paper's 0.4 s.
inline constexpr double usual_move = 0.2;

/// Relative residual at which a step's system counts as solved [-]: solver.tolerance, or 100 solver.tolerance for the
/// adaptive integrator with multigrid, whose error is then still a hundred times below that of the steps (MODEL.md,
/// I29).
double solver_tolerance(const Parameters& p);

/// Displacement after which drag coefficients are recomputed [um]: ecm.drag_lag, with the adaptive integrator times
/// dt / 0.4 s for steps longer than the paper's 0.4 s (MODEL.md, I30).
double drag_lag(const Parameters& p, double dt);

/// Maximum number of halvings of a step by the adaptive integrator.
inline constexpr int max_halvings = 7;

/// The shortest step of p.run.integrator [s].
double shortest_step(const Parameters& p);

/// The largest permitted step of p.run.integrator [s].
double largest_step(const Parameters& p, const StepLimits& limits);

/// The longest step of a run: run.time_step, halved until it is stable [s].
double longest_step(const Parameters& p, const StepLimits& limits);

/// `step`, rounded down to two significant digits [s].
double rounded_down(double step);

/// Why run.time_step is too long, and a stable value; empty if run.time_step or, with the adaptive integrator, the
/// shortest halved step is stable.
std::string fault_of_step(const Parameters& p, const StepLimits& limits);

/// @throws NumericalFailure if run.time_step is too long, with a stable value
void require_stable_step(const Parameters& p, const StepLimits& limits);
void require_stable_step(const Parameters& p); ///< the same in a uniform matrix

/// The limits in one sentence.
std::string describe(const StepLimits& limits);

} // namespace matrigrate
