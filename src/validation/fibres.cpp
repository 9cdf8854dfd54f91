#include "validation/fibre_gels.hpp"

#include "ecm/law/material.hpp"
#include "ecm/loop/fibres.hpp"
#include "observe/reaction.hpp"
#include "sph/kernel.hpp"
#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/closed_forms.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

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
  return {fit_slope(Y, u), 0.0, grip.y() / (a.s.ecm.period_x * a.p.ecm.thickness)};
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

namespace {

constexpr double judged_up_to = 0.10; // strain
constexpr double data_up_to = 0.15;   // strain
constexpr double agreement = 0.15;    // largest rms relative error that is called agreement
constexpr double rest_modulus = 0.01; // Young's modulus of what is no fibre [kPa]

/// A collagen gel: its concentration [mg/ml], the k_0 [kPa] fitted to it, and its measured stress [Pa] over strain.
struct CollagenGel {
  double concentration, k_0;
  report::Series measured;
};

/// Gels of three concentrations, extensional rheometry attributed to Steinwachs et al. 2016 (Nature Methods 13:171), as
/// distributed with the documentation of saenopy (notebook on materials; labelled shear there). k_0 from Heck et al.
/// 2020, Fig 2C.
std::vector<CollagenGel> collagen_gels() {
  return {
      {0.6,
       0.447,
       {.x = {0.0189, 0.0393, 0.0597, 0.0801, 0.100, 0.121, 0.141, 0.162, 0.182, 0.202, 0.223, 0.243, 0.263, 0.284},
        .y = {0.59, 1.08, 1.57, 2.14, 2.89, 3.83, 5.09, 6.77, 8.94, 11.7, 14.9, 18.6, 22.8, 27.1}}},
      {1.2,
       1.645,
       {.x = {0.0171, 0.0381, 0.0587, 0.0792, 0.0996, 0.120, 0.140, 0.161, 0.181, 0.202, 0.222,
              0.242,  0.263,  0.283,  0.304,  0.324,  0.344, 0.365, 0.385, 0.406, 0.426},
        .y = {2.57, 4.69, 6.34, 7.93, 9.56, 11.4, 13.5, 16.2, 19.7, 24.1, 29.5,
              36.3, 44.3, 53.6, 63.7, 74.7, 86.1, 97.5, 110,  122,  133}}},
      {2.4,
       5.208,
       {.x = {0.0159, 0.0376, 0.0582, 0.0786, 0.0990, 0.119, 0.140, 0.160, 0.180, 0.201, 0.221, 0.241},
        .y = {8.46, 16.8, 24.3, 33.4, 45.4, 61.1, 81.6, 106, 134, 165, 196, 226}}},
  };
}

Parameters gel(Parameters p, double k_0) {
  p.ecm.youngs_modulus = rest_modulus;
  p.fibres.arrangement = FibreArrangement::isotropic;
  p.fibres.stiffness = k_0;
  return p;
}

std::vector<Stretch> lattice_of(const Parameters& p, Sides sides = Sides::held) {
  return affine_lattice(p, largest_strain * 1.01, lattice_increments, sides);
}

/// Root-mean-square error of a curve relative to points [Pa] up to a strain.
double relative_error(const std::vector<Stretch>& curve, const report::Series& points, double up_to) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < points.x.size(); ++k) {
    if (points.x[k] > up_to + 1e-9) continue;
    const double error = 1e3 * stress_at(curve, points.x[k]) / points.y[k] - 1.0;
    sum += error * error;
    ++count;
  }
  return std::sqrt(sum / count);
}

/// The semi-affine law in steps of 0.01 [Pa].
report::Series law_curve(const Parameters& p, Sides sides) {
  report::Series points;
  for (int k = 1; k <= strip_increments; ++k)
    points.add(0.01 * k, 1e3 * p.fibres.stiffness
                             * semi_affine_stress(0.01 * k, p.fibres.onset, p.fibres.stiffening_strain, sides));
  return points;
}

/// Strain at which the curve of the infinite lattice leaves that of fibres that never stiffen.
double onset_of(const Parameters& p) {
  Parameters plain = p;
  plain.fibres.onset = 10.0;
  const std::vector<Stretch> stiffening = affine_lattice(p, largest_strain, lattice_increments, Sides::held);
  const std::vector<Stretch> without = affine_lattice(plain, largest_strain, lattice_increments, Sides::held);
  for (std::size_t k = 0; k < lattice_increments; ++k)
    if (stiffening[k].stress > 1.0001 * without[k].stress) return stiffening[k].strain;
  return std::nan("");
}

/// Error of the infinite lattice against the semi-affine law, both with the same sides.
double law_error(const Parameters& p, Sides sides) {
  return relative_error(lattice_of(p, sides), law_curve(p, sides), judged_up_to);
}

Parameters without_rest(Parameters p) {
  p.ecm.youngs_modulus = 1e-9;
  return p;
}

void check_homogeneous(const std::string& name, const std::vector<Stretch>& specimen,
                       const std::vector<Stretch>& lattice, double strain, Result& result) {
  result.checks.push_back({fmt::format("{}: stress of the specimen over the infinite lattice at {}", name, strain),
                           stress_at(specimen, strain) / stress_at(lattice, strain), 1.0, 0.01,
                           "both are homogeneous: steps in time, and the end of relaxation"});
}

} // namespace

Result fibres(const Parameters& p) {
  Result result;
  result.table.columns = {"k_0_Pa", "strain", "nominal_stress_Pa", "infinite_lattice_Pa", "semi_affine_Pa"};
  report::Plot plot{.title = "Isotropic fibrillar gels of 0.6, 1.2 and 2.4 mg/ml",
                    .x_label = "strain",
                    .y_label = "nominal stress (Pa)",
                    .log_y = true};
  int colour = 0;
  for (const auto& [concentration, k_0, data] : collagen_gels()) {
    const Parameters q = gel(p, k_0);
    const std::vector<Stretch> specimen = pull_strip(q, largest_strain, strip_increments);
    const std::vector<Stretch> lattice = lattice_of(q);
    const report::Series law_points = law_curve(q, Sides::held);
    const std::string name = fmt::format("{} mg/ml", concentration);
    report::Series model{.label = name + ", model", .colour = colour};
    report::Series measured{.label = name + ", measured", .mark = report::Mark::points, .colour = colour};
    report::Series law{.label = name + ", semi-affine law", .mark = report::Mark::dashed, .colour = colour++};
    for (std::size_t k = 0; k < specimen.size(); ++k) {
      const Stretch& s = specimen[k];
      result.table.add({1e3 * k_0, s.strain, 1e3 * s.stress, 1e3 * stress_at(lattice, s.strain), law_points.y[k]});
      model.add(s.strain, 1e3 * s.stress);
      law.add(s.strain, law_points.y[k]);
    }
    for (std::size_t k = 0; k < data.x.size(); ++k)
      if (data.x[k] <= largest_strain) measured.add(data.x[k], data.y[k]);
    plot.series.insert(plot.series.end(), {model, measured, law});
    for (const double at : {0.06, 0.12}) check_homogeneous(name, specimen, lattice, at, result);
    result.checks.push_back({fmt::format("{}: strain at which stiffening sets in", name), onset_of(q), p.fibres.onset,
                             2.0 * largest_strain / lattice_increments, "two increments of the infinite lattice"});
    const double error = relative_error(specimen, law_points, judged_up_to);
    const double from_data = relative_error(specimen, data, data_up_to);
    const double bare_error = law_error(without_rest(q), Sides::held);
    if (concentration > 1.0)
      result.claims.push_back(
          {fmt::format("{}: rms relative error of the stress to strain {:.2f} against the semi-affine law, sides held "
                       "in both (to the measured curve: {:.2f} to strain {:.2f}, not judged)",
                       name, judged_up_to, from_data, data_up_to),
           error, agreement, 0.0, "what agreement is taken to mean here", Sense::at_most});
    result.claim_notes.push_back(fmt::format(
        "{}: rms relative error {:.2f} to strain {:.2f} against the measured curve, whose source labels it shear.",
        name, from_data, data_up_to));
    if (concentration < 1.0)
      result.claim_notes.push_back(
          fmt::format("{} is not judged: rms relative error {:.2f} against the law, and {:.2f} without the elastic "
                      "rest of 10 Pa, which the law does not have and which is a good part of so soft a gel's stress.",
                      name, error, bare_error));
    result.remarks.push_back(fmt::format("{}, rms relative error of the infinite lattice to strain {:.2f}: {:.2f}, "
                                         "with free sides of lattice and law {:.2f}, without the elastic rest {:.2f}.",
                                         name, judged_up_to, law_error(q, Sides::held), law_error(q, Sides::free),
                                         bare_error));
  }
  result.add("fibres", "Uniaxial stretch with held sides, quasi-static, against measured gels and the semi-affine law.",
             plot);
  return result;
}

Result fibres_uniaxial(const Parameters& p) {
  Result result;
  result.table.columns = {"angle_to_fibres_deg", "strain", "nominal_stress_Pa", "infinite_lattice_Pa",
                          "isotropic_gel_Pa"};
  report::Plot plot{.title = "Uniaxial fibrillar gel, stretched along and across its fibres",
                    .x_label = "strain",
                    .y_label = "nominal stress (Pa)",
                    .log_y = true};
  const std::vector<Stretch> isotropic = lattice_of(gel(p, collagen_gels().back().k_0));
  report::Series beside{.label = "isotropic, 2.4 mg/ml", .mark = report::Mark::dashed};
  std::vector<std::vector<Stretch>> specimens;
  for (const double angle : {0.0, 90.0}) {
    const std::string name = angle == 0.0 ? "along" : "across";
    Parameters q = gel(p, 10.0);
    q.fibres.arrangement = FibreArrangement::uniaxial;
    q.fibres.direction_deg = angle;
    const std::vector<Stretch>& specimen = specimens.emplace_back(pull_strip(q, largest_strain, strip_increments));
    const std::vector<Stretch> lattice = lattice_of(q);
    report::Series& curve = plot.series.emplace_back(report::Series{.label = name});
    for (const Stretch& s : specimen) {
      const double of_isotropic = 1e3 * stress_at(isotropic, s.strain);
      result.table.add({angle, s.strain, 1e3 * s.stress, 1e3 * stress_at(lattice, s.strain), of_isotropic});
      curve.add(s.strain, 1e3 * s.stress);
      if (angle == 0.0) beside.add(s.strain, of_isotropic);
    }
    check_homogeneous(name, specimen, lattice, 0.06, result);
  }
  plot.series.push_back(beside);
  for (const double strain : {0.05, 0.1}) {
    const double along = stress_at(specimens[0], strain);
    result.claims.push_back({fmt::format("stress along over the isotropic gel of 2.4 mg/ml at {}", strain),
                             along / stress_at(isotropic, strain), 1.5, 0.5,
                             "the paper's Fig 2D: somewhat stiffer along; between once and twice"});
    result.claims.push_back({fmt::format("stress along over stress across at {}", strain),
                             along / stress_at(specimens[1], strain), 10.0, 0.0, "the paper's Fig 2D: very soft across",
                             Sense::at_least});
  }
  result.add("fibres-uniaxial", "Quasi-static stretch with held sides; k_0 = 10 kPa, 30 degrees.", plot);
  return result;
}

} // namespace matrigrate::validation
