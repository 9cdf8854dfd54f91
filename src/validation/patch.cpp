#include "ecm/law/material.hpp"
#include "ecm/loop/deformation.hpp"
#include "ecm/loop/stress.hpp"
#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::validation {

namespace {

const Mat2 shape = (Mat2() << 1.0, 0.5, -0.3, -0.7).finished(); // stretch, shear and rotation at once

/// Largest error of F over all particles of a free rectangle under x = (I + H) X, over |H|.
double gradient_error(const Parameters& p, const Mat2& H) {
  const double dp = p.ecm.particle_spacing;
  EcmState ecm = rectangle(p.ecm, 30 * dp, 15 * dp, 0.0);
  const Reference ref(ecm, p.ecm);
  for (std::size_t i = 0; i < ecm.size(); ++i) ecm.x[i] = ecm.X[i] + H * ecm.X[i];
  double worst = 0.0;
  for (std::size_t i = 0; i < ecm.size(); ++i)
    worst = std::max(worst, (deformation_gradient(ecm, ref, i) - Mat2::Identity() - H).norm());
  return worst / H.norm();
}

/// A disc clamped two supports deep.
Simulation deep_rimmed_disc(const Parameters& p) {
  const Parameters q = with_disc(p, 25.0 * p.ecm.particle_spacing);
  EcmState ecm = disc(q);
  for (std::size_t i = 0; i < ecm.size(); ++i)
    ecm.clamped[i] = ecm.X[i].norm() > q.ecm.radius - 4.0 * q.ecm.smoothing_length;
  return {q, std::move(ecm)};
}

double displacement_error(const EcmState& ecm, const Mat2& H) {
  double worst = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    worst = std::max(worst, (ecm.displacement(i) - H * ecm.X[i]).norm());
    largest = std::max(largest, (H * ecm.X[i]).norm());
  }
  return worst / largest;
}

/// Largest elastic force on a particle of a uniformly stressed rectangle, over sigma dp t_z; away from the edges, and
/// overall.
std::pair<double, double> spurious_force(const Parameters& p) {
  const double dp = p.ecm.particle_spacing;
  EcmState ecm = rectangle(p.ecm, 30 * dp, 30 * dp, 0.0);
  const Reference ref(ecm, p.ecm);
  const double sigma = 0.1 * p.ecm.youngs_modulus;
  for (Mat2& S : ecm.S) S = sigma * (Mat2() << 1.0, 0.0, 0.0, -1.0).finished();
  SolidFields solid;
  std::vector<Vec2> force(ecm.size(), Vec2::Zero());
  add_elastic_forces(ecm, p.ecm, ref, solid, force);
  double inside = 0.0;
  double anywhere = 0.0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    const double to_edge = 15 * dp - ecm.X[i].cwiseAbs().maxCoeff();
    const double a = force[i].norm() / (sigma * dp * p.ecm.thickness);
    anywhere = std::max(anywhere, a);
    if (to_edge > 4.0 * p.ecm.smoothing_length) inside = std::max(inside, a);
  }
  return {inside, anywhere};
}

} // namespace

Result patch(const Parameters& p) {
  Result result;
  result.checks.push_back({"error of F over |H|, free rectangle, every particle", gradient_error(p, 0.1 * shape), 0.0,
                           1e-12, "exact by construction of the gradient correction: round-off alone"});

  const double size = 1e-5;
  Simulation a = deep_rimmed_disc(p);
  result.table.columns = {"time_s", "relative_error"};
  const double tau = p.ecm.viscosity / moduli(p.ecm).G;
  const auto field = [&](const Vec2& X) -> Vec2 { return size * shape * X; };
  drive_clamped(a, field, 10.0 * p.run.time_step);
  a.march_for(16.0 * tau, {}, [&](const State& s) {
    result.table.add({s.t, displacement_error(s.ecm, size * shape)});
    return true;
  });
  result.checks.push_back(
      {"displacement error of a driven disc at rest, over the largest displacement",
       displacement_error(a.s.ecm, size * shape), 0.0, std::exp(-16.0) * 10.0 + 10.0 * size + 10.0 * p.solver.tolerance,
       "16 relaxation times, path dependence of the rate law (|H|), solver tolerance; tenfold each"});

  const auto [inside, anywhere] = spurious_force(p);
  result.checks.push_back({"force under uniform stress, two supports from an edge, over sigma dp t_z", inside, 0.0,
                           1e-12, "the sums cancel on a lattice: round-off alone"});
  result.remarks.push_back(fmt::format("At a free edge the same force reaches {:.2f} sigma dp t_z: there it is the "
                                       "traction that the edge lacks, spread over the kernel's support.",
                                       anywhere));
  result.add("patch", "The inside of a disc follows its linearly displaced rim.",
             {.title = "Patch: a driven disc approaches the linear field",
              .x_label = "time (s)",
              .y_label = "largest error / largest displacement",
              .log_y = true,
              .series = {result.curve("measured", "time_s", "relative_error")}});
  return result;
}

} // namespace matrigrate::validation
