#include "ecm/law/material.hpp"
#include "ecm/loop/stress.hpp"
#include "ecm/loop/viscosity.hpp"
#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/specimen.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace matrigrate::validation {

namespace {

/// A disc without any clamp.
EcmState free_disc(const Parameters& p) {
  EcmState ecm = disc(with_disc(p, 15.0 * p.ecm.particle_spacing));
  std::fill(ecm.clamped.begin(), ecm.clamped.end(), std::uint8_t{0});
  return ecm;
}

/// Places the body at a turn and shift of its reference, moving rigidly.
void move_rigidly(EcmState& ecm, double angle, const Vec2& shift, double spin, const Vec2& speed) {
  const Mat2 R = Eigen::Rotation2Dd(angle).toRotationMatrix();
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    ecm.x[i] = R * ecm.X[i] + shift;
    ecm.v[i] = spin * perpendicular(R * ecm.X[i]) + speed;
  }
}

void move_on(EcmState& ecm, double dt) {
  for (std::size_t i = 0; i < ecm.size(); ++i) ecm.x[i] += dt * ecm.v[i];
}

/// @param solid  gets what advance_stress() takes
std::vector<Vec2> elastic_forces(const EcmState& ecm, const Parameters& p, const Reference& ref, SolidFields& solid) {
  std::vector<Vec2> force(ecm.size(), Vec2::Zero());
  add_elastic_forces(ecm, p.ecm, ref, solid, force);
  return force;
}

/// Stress and force that one step of rigid motion leaves, over 2G and over E dp t_z.
std::pair<double, double> stress_and_force(const Parameters& p) {
  EcmState ecm = free_disc(p);
  const Reference ref(ecm, p.ecm);
  move_rigidly(ecm, std::numbers::pi / 6.0, Vec2(12.0, -7.0), 0.01, Vec2(0.3, 0.2));
  const double force_scale = p.ecm.youngs_modulus * p.ecm.particle_spacing * p.ecm.thickness;
  SolidFields solid;
  double force = 0.0;
  for (const Vec2& f : elastic_forces(ecm, p, ref, solid)) force = std::max(force, f.norm() / force_scale);
  move_on(ecm, p.run.time_step);
  advance_stress(ecm, p.ecm, ref, solid, p.run.time_step);
  double stress = 0.0;
  for (std::size_t i = 0; i < ecm.size(); ++i)
    stress = std::max({stress, ecm.S[i].norm() / (2.0 * moduli(p.ecm).G), std::abs(ecm.rho[i] - 1.0)});
  return {stress, force};
}

/// Relative error of a uniform deviatoric stress after a quarter turn in n steps, against the turned stress.
double turned_stress_error(const Parameters& p, int n) {
  EcmState ecm = free_disc(p);
  const Reference ref(ecm, p.ecm);
  const Mat2 S0 = (Mat2() << 0.01, 0.004, 0.004, -0.01).finished();
  std::fill(ecm.S.begin(), ecm.S.end(), S0);
  const double step = 0.5 * std::numbers::pi / n;
  for (int k = 0; k < n; ++k) {
    move_rigidly(ecm, k * step, Vec2::Zero(), step, Vec2::Zero());
    SolidFields solid;
    elastic_forces(ecm, p, ref, solid);
    move_on(ecm, 1.0);
    advance_stress(ecm, p.ecm, ref, solid, 1.0);
  }
  const Mat2 R = Eigen::Rotation2Dd(0.5 * std::numbers::pi).toRotationMatrix();
  double worst = 0.0;
  for (const Mat2& S : ecm.S) worst = std::max(worst, (S - R * S0 * R.transpose()).norm() / S0.norm());
  return worst;
}

/// Net force and torque of internal forces, over the sums of their magnitudes.
struct Balance {
  double force, torque;
};

/// Of the elastic forces and of the drag of a wildly deformed and stressed body.
std::pair<Balance, Balance> internal_balance(const Parameters& p) {
  EcmState ecm = free_disc(p);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    const Vec2& X = ecm.X[i];
    ecm.x[i] = X + Vec2(0.8 * std::sin(0.3 * X.y()) + 0.2 * X.x(), std::cos(0.2 * X.x() + 0.1 * X.y()));
    ecm.v[i] = Vec2(std::sin(0.5 * X.x()), std::cos(0.4 * X.y() - X.x()));
    ecm.S[i] << 0.01 * std::sin(X.x()), 0.02 * std::cos(X.y()), 0.02 * std::cos(X.y()), -0.01;
    ecm.rho[i] = 1.0 + 0.1 * std::sin(X.x() + X.y());
    if (X.x() > 8.0) ecm.f[i] = 0.6;
  }
  const Reference ref(ecm, p.ecm);
  SolidFields solid;
  const std::vector<Vec2> elastic = elastic_forces(ecm, p, ref, solid);
  const Adjacency pairs = neighbours_within(ecm.x, 2.0 * p.ecm.smoothing_length, 0.0);
  DragSystem A;
  assemble_viscosity(ecm, p.ecm, RowPattern(pairs, ecm.clamped), A);
  std::vector<Vec2> drag(ecm.size());
  multiply(A, ecm.v, drag);
  const auto balance = [&](const std::vector<Vec2>& force) {
    Vec2 sum = Vec2::Zero();
    double torque = 0.0, magnitude = 0.0, moment = 0.0;
    for (std::size_t i = 0; i < ecm.size(); ++i) {
      sum += force[i];
      torque += cross(ecm.x[i], force[i]);
      magnitude += force[i].norm();
      moment += ecm.x[i].norm() * force[i].norm();
    }
    return Balance{sum.norm() / magnitude, std::abs(torque) / moment};
  };
  return {balance(elastic), balance(drag)};
}

} // namespace

Result rigid(const Parameters& p) {
  Result result;
  const std::string round_off = "round-off of sums over some 700 particles";
  const auto [stress, force] = stress_and_force(p);
  result.checks.push_back({"stress made by rigid motion, over 2G", stress, 0.0, 1e-12, round_off});
  result.checks.push_back({"force on a turned and shifted body, over E dp t_z", force, 0.0, 1e-12, round_off});
  const auto [elastic, drag] = internal_balance(p);
  result.checks.push_back({"net elastic force, over the sum of magnitudes", elastic.force, 0.0, 1e-13, round_off});
  result.checks.push_back({"net elastic torque, over the sum of moments", elastic.torque, 0.0, 1e-12, round_off});
  result.checks.push_back({"net drag force, over the sum of magnitudes", drag.force, 0.0, 1e-13, round_off});
  result.remarks.push_back(fmt::format(
      "The pair drag of Eq. (2) acts along velocity differences, not along the line between particles: its net torque "
      "is {:.2g} of the sum of moments here. This is the paper's form (mu times the Laplacian of v), which resists the "
      "rotation of a finite body; inside a gel that is clamped at its rim it changes nothing.",
      drag.torque));

  result.table.columns = {"steps_per_quarter_turn", "relative_error"};
  for (const int n : {50, 100, 200, 400}) result.table.add({static_cast<double>(n), turned_stress_error(p, n)});
  const report::Series curve =
      result.curve("measured", "steps_per_quarter_turn", "relative_error", report::Mark::points);
  const double order = std::log2(curve.y[2] / curve.y[3]);
  result.checks.push_back({"order in dt of a stress turned by 90 degrees", order, 1.0, 0.05,
                           "explicit Euler is of first order; 5 % for the terms of second order at 400 steps"});
  report::Series ideal{.label = "first order", .mark = report::Mark::dashed};
  for (const double n : curve.x) ideal.add(n, curve.y.back() * curve.x.back() / n);
  result.add("rigid", "Error of a deviatoric stress carried through a quarter turn.",
             {.title = "Rigid: a stress turned by 90 degrees",
              .x_label = "steps",
              .y_label = "relative error",
              .log_x = true,
              .log_y = true,
              .series = {curve, ideal}});
  return result;
}

} // namespace matrigrate::validation
