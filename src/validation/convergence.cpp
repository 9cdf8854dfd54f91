#include "ecm/law/material.hpp"
#include "simulation/step_limits.hpp"
#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/closed_forms.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace matrigrate::validation {

namespace {

constexpr double length = 48.0;    // period of the manufactured field along x [um]
constexpr double height = 48.0;    // between its zeros along y [um]
constexpr double amplitude = 1e-4; // [um]; small, so that linear elasticity holds

/// A smooth field that vanishes at y = +-height/2, and the body force that it needs in linear elasticity.
struct Manufactured {
  double k = 2.0 * std::numbers::pi / length;
  double q = std::numbers::pi / height;
  Moduli m;

  Vec2 u(const Vec2& X) const { return {amplitude * std::sin(k * X.x()) * std::cos(q * X.y()), 0.0}; }
  Vec2 b(const Vec2& X) const {
    const double lame_plus_G = m.K + m.G / 3.0;
    return {(m.longitudinal() * k * k + m.G * q * q) * u(X).x(),
            lame_plus_G * amplitude * k * q * std::cos(k * X.x()) * std::sin(q * X.y())};
  }
};

/// Relative error (2-norm) of the static field at spacing dp, h/dp kept.
/// @param exact_walls  walls two supports deep follow the field; otherwise they stand still where it vanishes
double static_error(const Parameters& p, double dp, bool exact_walls) {
  Parameters q = p;
  q.ecm.smoothing_length = p.ecm.smoothing_length / p.ecm.particle_spacing * dp;
  q.ecm.particle_spacing = dp;
  q.ecm.verlet_skin = 0.5 * dp;
  q.run.time_step = std::min(p.run.time_step, 0.5 * step_limits(q).smallest());
  const Manufactured field{.m = moduli(q.ecm)};
  const double support = 2.0 * q.ecm.smoothing_length;
  EcmState ecm = strip(q.ecm, length, height - dp + (exact_walls ? 2.0 * support + 2.0 * dp : 0.0));
  if (exact_walls)
    for (std::size_t i = 0; i < ecm.size(); ++i) ecm.clamped[i] = std::abs(ecm.X[i].y()) > 0.5 * height - 0.1 * dp;
  Simulation a(q, std::move(ecm));
  const Loads load = [&](const State& s, std::span<Vec2> force) {
    for (std::size_t i = 0; i < s.ecm.size(); ++i) force[i] += s.ecm.V0 * q.ecm.thickness * field.b(s.ecm.X[i]);
  };
  const double tau = q.ecm.viscosity / field.m.G;
  if (exact_walls) drive_clamped(a, std::bind_front(&Manufactured::u, field), tau, load);
  a.march_for(14.0 * tau, load);
  double difference = 0.0, norm = 0.0;
  for (std::size_t i = 0; i < a.s.ecm.size(); ++i) {
    if (a.s.ecm.clamped[i]) continue;
    difference += (a.s.ecm.displacement(i) - field.u(a.s.ecm.X[i])).squaredNorm();
    norm += field.u(a.s.ecm.X[i]).squaredNorm();
  }
  return std::sqrt(difference / norm);
}

/// Displacement of the middle of a sheared layer after one relaxation time, in n steps.
double creep_displacement(const Parameters& p, int n) {
  Parameters q = p;
  const double tau = p.ecm.viscosity / moduli(p.ecm).G;
  q.run.time_step = tau / n;
  q.solver.tolerance = 1e-12;
  const double dp = p.ecm.particle_spacing;
  Simulation a(q, strip(q.ecm, 12 * dp, 12 * dp));
  a.march_for(tau, body_force(q, Vec2(1e-5, 0.0)));
  return mid_displacement(a.s.ecm, q.ecm).x();
}

double order_of(const report::Series& s) {
  const std::size_t n = s.x.size();
  return std::log(s.y[n - 2] / s.y[n - 1]) / std::log(s.x[n - 2] / s.x[n - 1]);
}

report::Series ideal(const report::Series& s, double order, const std::string& label) {
  report::Series line{.label = label, .x = s.x, .mark = report::Mark::dashed};
  for (const double x : s.x) line.y.push_back(s.y.back() * std::pow(x / s.x.back(), order));
  return line;
}

} // namespace

Result convergence(const Parameters& p) {
  Result result;
  result.table.columns = {"study", "spacing_um_or_step_s", "relative_error"};
  report::Series inside{.label = "walls follow the field"}, clamped{.label = "walls at rest"};
  for (const double dp : {4.0, 2.0, 1.0}) {
    for (auto [series, exact_walls] : {std::pair(&inside, true), std::pair(&clamped, false)}) {
      series->add(dp, static_error(p, dp, exact_walls));
      result.table.add({exact_walls ? 0.0 : 1.0, dp, series->y.back()});
    }
  }
  report::Series steps{.label = "measured", .mark = report::Mark::points};
  const double finest = creep_displacement(p, 640);
  const double finer = creep_displacement(p, 1280);
  const double limit = 2.0 * finer - finest; // Richardson, first order
  for (const int n : {40, 80, 160, 320}) {
    steps.add(p.ecm.viscosity / moduli(p.ecm).G / n, std::abs(creep_displacement(p, n) / limit - 1.0));
    result.table.add({2.0, steps.x.back(), steps.y.back()});
  }
  result.checks.push_back(
      {"order in dp, walls that follow the field", order_of(inside), 2.0, 0.3,
       "linear fields are exact and the lattice is symmetric: second order; halvings from 2 µm on show it to 0.3"});
  result.checks.push_back(
      {"order in dp, walls at rest", order_of(clamped), 1.5, 0.5,
       "a rigid wall is placed to within a spacing: first order at the wall, second inside; between the two"});
  result.checks.push_back(
      {"order in dt", order_of(steps), 1.0, 0.05, "explicit Euler; second-order terms of a 1/320 step"});
  result.add("convergence", "Static error of a manufactured field, h/dp kept.",
             {.title = "Convergence in particle spacing",
              .x_label = "spacing of particles, dp (µm)",
              .y_label = "relative error",
              .log_x = true,
              .log_y = true,
              .series = {inside, clamped, ideal(inside, 2.0, "second order"), ideal(clamped, 1.0, "first order")}});
  result.add("step", "Error of a creep test after one relaxation time.",
             {.title = "Convergence in time step",
              .x_label = "time step, dt (s)",
              .y_label = "relative error",
              .log_x = true,
              .log_y = true,
              .series = {steps, ideal(steps, 1.0, "first order")}});
  return result;
}

} // namespace matrigrate::validation
