#include "simulation/step_limits.hpp"

#include "base/failure.hpp"
#include "base/vector.hpp"
#include "ecm/law/material.hpp"
#include "ecm/loop/fibres.hpp"
#include "ecm/loop/viscosity.hpp"
#include "state/initial.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace matrigrate {

namespace {

/// Symbols of the discrete operators for one wave vector, a particle.
struct Symbols {
  Vec2 gradient = Vec2::Zero(); // g, corrected; the gradient of exp(i k.X) is i g [1/um]
  Vec2 raw_gradient = Vec2::Zero();
  double drag = 0.0;          // d [nN s/um]
  double hourglass = 0.0;     // c [nN/um]
  Mat2 fibres = Mat2::Zero(); // all of them taut, before they stiffen [nN/um]
};

/// A fibre between a particle inside the lattice and its neighbour at X.
struct Spring {
  Vec2 X;
  double k; // [nN/um]
};

std::vector<Spring> springs(const Parameters& p, const std::vector<Vec2>& patch) {
  std::vector<Spring> all;
  if (p.fibres.arrangement == FibreArrangement::none) return all;
  const Kernel kernel(p.ecm.smoothing_length);
  double sum = 0.0;
  for (const Vec2& X : patch) sum += kernel.W(X.norm());
  const std::shared_ptr<const FibreTable> table = fibre_table(p);
  const double at_rest = table == nullptr ? fibre_stiffness(0.0, p.fibres) : p.fibres.stiffness * table->at_rest();
  for (const Vec2& X : patch)
    if (X.squaredNorm() > 0.0 && joined(X, p.fibres))
      all.push_back({X, p.ecm.thickness * kernel.W(X.norm()) / sum * at_rest});
  return all;
}

Symbols symbols(const Vec2& k, const EcmParameters& p, const std::vector<Vec2>& patch,
                const std::vector<Spring>& fibres) {
  const Kernel kernel(p.smoothing_length);
  const double V0 = particle_area(p);
  Symbols s;
  double support = 0.0; // A = support I
  for (const Vec2& X : patch) {
    const double slope = kernel.W_slope(X.norm());
    support -= 0.5 * V0 * slope * X.squaredNorm();
    s.raw_gradient -= V0 * slope * std::sin(k.dot(X)) * X;
    s.drag += pair_drag(X.squaredNorm(), slope, V0, p.viscosity, p.thickness, p.smoothing_length)
              * (1.0 - std::cos(k.dot(X)));
  }
  s.gradient = s.raw_gradient / support;
  for (const Vec2& X : patch) {
    if (X.squaredNorm() == 0.0) continue;
    const double c =
        p.hourglass_weight * p.youngs_modulus * p.thickness * V0 * V0 * kernel.W(X.norm()) / X.squaredNorm();
    const double half_phase = 0.5 * k.dot(X);
    const double error = s.gradient.dot(X) * std::cos(half_phase) - 2.0 * std::sin(half_phase);
    s.hourglass += 0.5 * c * error * error;
  }
  for (const Spring& spring : fibres)
    s.fibres += spring.k * (1.0 - std::cos(k.dot(spring.X))) / spring.X.squaredNorm() * spring.X * spring.X.transpose();
  return s;
}

double elastic_rate(const Symbols& s, const EcmParameters& p, const Moduli& m) {
  const Mat2 stiffness = p.thickness * particle_area(p)
                             * ((m.K + m.G / 3.0) * s.gradient * s.gradient.transpose()
                                + m.G * s.gradient.squaredNorm() * Mat2::Identity())
                         + s.hourglass * Mat2::Identity() + s.fibres;
  return Eigen::SelfAdjointEigenSolver<Mat2>(stiffness, Eigen::EigenvaluesOnly).eigenvalues()(1) / s.drag;
}

double fluid_rate(const Symbols& s, const EcmParameters& p, const Moduli& m) {
  return p.thickness * particle_area(p) * m.K * s.raw_gradient.squaredNorm() / s.drag;
}

} // namespace

std::string StepLimits::binding() const {
  return elastic_s <= fluid_s ? "elasticity of the intact matrix (K, G, fibres against mu)"
                              : "pressure of the degraded matrix (K against mu)";
}

StepLimits step_limits(const Parameters& p) {
  const std::vector<Vec2> patch = lattice_patch(p.ecm, 2.0 * p.ecm.smoothing_length);
  const std::vector<Spring> fibres = springs(p, patch);
  const Moduli m = moduli(p.ecm);
  double elastic = 0.0;
  double fluid = 0.0;
  constexpr int samples = 64; // over half the zone, which is symmetric to its centre; covers both lattices' zones
  const double k_max = std::numbers::pi / p.ecm.particle_spacing * 2.0 / std::numbers::sqrt3;
  for (int a = -samples; a <= samples; ++a)
    for (int b = 0; b <= samples; ++b) {
      if (b == 0 && a == 0) continue;
      const Symbols s = symbols(Vec2(a, b) * (k_max / samples), p.ecm, patch, fibres);
      if (s.drag <= 0.0) continue;
      elastic = std::max(elastic, elastic_rate(s, p.ecm, m));
      fluid = std::max(fluid, fluid_rate(s, p.ecm, m));
    }
  return {.elastic_s = 2.0 / elastic, .fluid_s = 2.0 / fluid};
}

StepLimits step_limits(const Parameters& p, const EcmState& ecm) {
  Parameters stiffest = p;
  if (!ecm.E_ratio.empty()) stiffest.ecm.youngs_modulus *= std::ranges::max(ecm.E_ratio);
  if (!ecm.fibre_ratio.empty()) stiffest.fibres.stiffness *= std::ranges::max(ecm.fibre_ratio);
  if (!ecm.fibre_direction.empty() && p.fibres.arrangement == FibreArrangement::uniaxial)
    stiffest.fibres.arrangement = FibreArrangement::isotropic;
  return step_limits(stiffest);
}

double relaxation_theta(const Parameters& p, double dt, const StepLimits& limits) {
  if (p.run.integrator == Integrator::reference) return 0.0;
  const double both = 1.0 / limits.elastic_s + 1.0 / limits.fluid_s; // where solid and fluid meet, their rates add up
  return std::max(0.0, 0.5 * dt * both - 0.4);
}

double solver_tolerance(const Parameters& p) {
  const bool looser = p.run.integrator == Integrator::adaptive && p.solver.method == SolverMethod::multigrid;
  return (looser ? 100.0 : 1.0) * p.solver.tolerance;
}

double drag_lag(const Parameters& p, double dt) {
  constexpr double paper = 0.4; // [s]
  const double steps = p.run.integrator == Integrator::adaptive ? std::max(1.0, dt / paper) : 1.0;
  return steps * p.ecm.drag_lag;
}

double largest_step(const Parameters& p, const StepLimits& limits) {
  constexpr double beyond = 4.0; // with relaxation_theta; further out it would govern the motion
  return (p.run.integrator == Integrator::reference ? 1.0 : beyond) * limits.smallest();
}

double rounded_down(double step) {
  const double unit = std::pow(10.0, std::floor(std::log10(step)) - 1.0);
  return unit * std::floor(step / unit);
}

double shortest_step(const Parameters& p) {
  return p.run.integrator == Integrator::reference ? p.run.time_step : std::ldexp(p.run.time_step, -max_halvings);
}

double longest_step(const Parameters& p, const StepLimits& limits) {
  double dt = p.run.time_step;
  while (dt > largest_step(p, limits) && dt > 1.5 * shortest_step(p)) dt *= 0.5;
  return dt;
}

std::string fault_of_step(const Parameters& p, const StepLimits& limits) {
  const double largest = largest_step(p, limits);
  if (shortest_step(p) <= largest) return {};
  const bool fixed = p.run.integrator == Integrator::reference;
  // a fixed step must be short enough for the recoil of protrusions as well: the paper's is
  const double advised = fixed ? std::min(rounded_down(largest), usual_time_step(p.run.integrator)) : largest;
  return fmt::format(
      "a step of {:.4g} s is longer than the largest stable one of the {} integrator, {:.3g} s, set by the {}; "
      "take {:.2g} s or less{}",
      p.run.time_step, fixed ? "reference" : "adaptive", largest, limits.binding(), advised,
      fixed ? ", or run.integrator = \"adaptive\" for longer steps" : "");
}

void require_stable_step(const Parameters& p, const StepLimits& limits) {
  if (const std::string fault = fault_of_step(p, limits); !fault.empty())
    throw NumericalFailure(FailureCause::step_limit, fault);
}

void require_stable_step(const Parameters& p) { require_stable_step(p, step_limits(p)); }

std::string describe(const StepLimits& limits) {
  return fmt::format(
      "steps are stable up to {:.3g} s for the elasticity of the intact matrix (K, G, fibres against mu) and up to "
      "{:.3g} s for the pressure of the degraded matrix (K against mu); the smaller one is set by the {}",
      limits.elastic_s, limits.fluid_s, limits.binding());
}

} // namespace matrigrate
