#include "validation/fibre_gels.hpp"

#include "ecm/law/material.hpp"
#include "ecm/loop/fibres.hpp"
#include "observe/reaction.hpp"
#include "sph/kernel.hpp"
#include "state/initial.hpp"
#include "validation/closed_forms.hpp"
#include "validation/specimen.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate::validation {

namespace {

constexpr double buckling_strain = 0.0008; // d_0
constexpr int columns = 12;                // of the strip, one period
constexpr int rows = 24;                   // of the strip between its ends

/// The root of a function that grows from below 0 at `low`.
template <class Function>
double root(double low, double high, const Function& f) {
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// Nominal stresses of the semi-affine law along and across the pull, over k_0.
Vec2 semi_affine_stresses(double along, double across, double eps_s, double d_s) {
  FibreParameters fibre;
  fibre.stiffness = 1.0;
  fibre.onset = eps_s;
  fibre.stiffening_strain = d_s;
  constexpr int directions = 2000;
  Vec2 sum = Vec2::Zero();
  for (int k = 0; k < directions; ++k) { // cosines of directions in space are uniform
    const double c = (k + 0.5) / directions;
    const double s2 = 1.0 - c * c;
    const double stretch = std::sqrt(along * along * c * c + across * across * s2);
    const double strain = stretch - 1.0;
    const double tension =
        strain >= 0.0 ? fibre_tension(strain, fibre) : buckling_strain * std::expm1(strain / buckling_strain);
    sum += tension / stretch * Vec2(along * c * c, 0.5 * across * s2);
  }
  return sum / directions;
}

/// The elastic rest of the gel, by the rate law of the matrix.
struct Rest {
  double rho = 1.0;
  Mat2 S = Mat2::Zero();
  double along = 1.0, across = 1.0; // stretches

  Rest stretched(double to_along, double to_across, const EcmParameters& p) const {
    const Mat2 L = (Mat2() << std::log(to_along / along), 0.0, 0.0, std::log(to_across / across)).finished();
    return {rho * std::exp(-L.trace()), S + jaumann_rate(S, L, moduli(p).G), to_along, to_across};
  }
  Vec2 nominal(const EcmParameters& p) const {
    const Mat2 sigma = cauchy_stress(rho, S, moduli(p).K);
    return {sigma(0, 0) * across, sigma(1, 1) * along};
  }
};

/// Nominal stresses of the fibres of an infinite lattice.
Vec2 lattice_stresses(double along, double across, const Parameters& p) {
  const Kernel kernel(p.ecm.smoothing_length);
  const std::vector<Vec2> patch = lattice_patch(p.ecm, kernel.support());
  double W = 0.0;
  for (const Vec2& X : patch) W += kernel.W(X.norm());
  Vec2 sum = Vec2::Zero();
  for (const Vec2& X : patch) {
    if (X.squaredNorm() == 0.0 || !joined(X, p.fibres)) continue;
    const Vec2 x(along * X.x(), across * X.y());
    const double strain = x.norm() / X.norm() - 1.0;
    const double pull = kernel.W(X.norm()) / W * fibre_tension(strain, p.fibres) / (1.0 + strain);
    sum += 0.5 * pull * x.cwiseProduct(X);
  }
  return sum / particle_area(p.ecm);
}

/// Stretch of the strip between its ends, and the pull on the upper one.
Stretch read(const Simulation& a) {
  std::vector<double> Y, u;
  for (std::size_t i = 0; i < a.s.ecm.size(); ++i) {
    if (a.s.ecm.clamped[i]) continue;
    Y.push_back(a.s.ecm.X[i].y());
    u.push_back(a.s.ecm.displacement(i).y());
  }
  const Vec2 grip = clamp_force(a.s, a.p, a.w, [](const Vec2& X) { return X.y() > 0.0; });
  return {fit_line(Y, u).slope, 0.0, grip.y() / (a.s.ecm.period_x * a.p.ecm.thickness)};
}

} // namespace

double semi_affine_stress(double strain, double eps_s, double d_s, Sides sides) {
  const double across = sides == Sides::held ? 1.0 : root(1e-3, 1.0, [&](double l) {
    return semi_affine_stresses(1.0 + strain, l, eps_s, d_s).y();
  });
  return semi_affine_stresses(1.0 + strain, across, eps_s, d_s).x();
}

std::vector<Stretch> affine_lattice(const Parameters& p, double largest, int increments, Sides sides) {
  std::vector<Stretch> curve;
  Rest rest;
  for (int k = 1; k <= increments; ++k) {
    const double along = 1.0 + largest * k / increments;
    const auto stresses = [&](double lateral) -> Vec2 {
      return rest.stretched(along, lateral, p.ecm).nominal(p.ecm) + lattice_stresses(along, lateral, p);
    };
    const double lateral = sides == Sides::held ? 1.0 : root(0.05, 1.2, [&](double l) { return stresses(l).y(); });
    curve.push_back({along - 1.0, lateral - 1.0, stresses(lateral).x()});
    rest = rest.stretched(along, lateral, p.ecm);
  }
  return curve;
}

std::vector<Stretch> pull_strip(const Parameters& p, double largest, int increments) {
  Parameters q = p;
  q.fibres.direction_deg += 90.0; // the strip is pulled along y
  Simulation a(q, strip(q.ecm, columns * q.ecm.particle_spacing, rows * q.ecm.particle_spacing));
  const double tau = q.ecm.viscosity / moduli(q.ecm).longitudinal(); // fibres only shorten it
  const double increment = largest / increments;
  std::vector<Stretch> curve;
  for (int k = 0; k < increments; ++k) {
    drive_clamped(
        a, [&](const Vec2& X) { return Vec2(0.0, increment * X.y()); }, tau);
    a.march_for(6.0 * tau);
    curve.push_back(read(a));
  }
  return curve;
}

double stress_at(const std::vector<Stretch>& curve, double strain) {
  Stretch before{0.0, 0.0, 0.0};
  for (const Stretch& point : curve) {
    if (point.strain >= strain)
      return before.stress + (strain - before.strain) / (point.strain - before.strain) * (point.stress - before.stress);
    before = point;
  }
  return std::nan("");
}

} // namespace matrigrate::validation
