#include "cell/nucleus.hpp"

#include "cell/area.hpp"
#include "cell/bending.hpp"
#include "cell/geometry.hpp"
#include "cell/spring.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace matrigrate {

namespace {

std::vector<double> each_segment(const CortexState& nucleus, double k) {
  return std::vector<double>(nucleus.size(), k);
}

/// Rest length of the springs of the chromatin, from a particle to its opposite one [um].
double diameter(const NucleusParameters& n) {
  return 2.0 * n.radius * (n.particles % 2 == 0 ? 1.0 : std::cos(0.5 * std::numbers::pi / n.particles));
}

} // namespace

CellParameters lamina(const Parameters& p) {
  const NucleusParameters& n = p.nucleus;
  CellParameters ring;
  ring.radius = n.radius;
  ring.particles = n.particles;
  const double l0 = initial_segment_length(ring);
  ring.spring_stiffness = n.stretch_stiffness / l0;
  ring.dashpot = n.retardation_time * ring.spring_stiffness;
  ring.bending_stiffness = n.bending_stiffness / l0;
  ring.area_stiffness = n.bulk_modulus * p.ecm.thickness * l0 / initial_area(ring);
  return ring;
}

CortexState round_nucleus(const Parameters& p, const CellStart& start) {
  return has_nucleus(p) ? round_cortex(lamina(p), start) : CortexState{};
}

double chromatin_stiffness(const NucleusParameters& n, double thickness) {
  return 4.0 * std::numbers::pi * n.shear_modulus * thickness / n.particles;
}

double nucleus_energy(const CortexState& nucleus, const Parameters& p) {
  const CellParameters ring = lamina(p);
  double sum = spring_energy(nucleus, each_segment(nucleus, ring.spring_stiffness)) + crowding_energy(nucleus, ring)
               + bending_energy(nucleus, ring) + area_energy(nucleus, ring);
  const double k = chromatin_stiffness(p.nucleus, p.ecm.thickness);
  for (std::size_t i = 0; i < nucleus.size() / 2; ++i) {
    const double stretch = (nucleus.x[i + nucleus.size() / 2] - nucleus.x[i]).norm() - diameter(p.nucleus);
    sum += 0.5 * k * stretch * stretch;
  }
  return sum;
}

void add_nucleus(const CortexState& nucleus, const Parameters& p, double dt, std::uint32_t first, std::span<Vec2> force,
                 DragSystem& A) {
  const CellParameters ring = lamina(p);
  add_springs(nucleus, ring, each_segment(nucleus, ring.spring_stiffness), dt, first, force, A);
  add_bending(nucleus, ring, dt, first, force, A);
  add_area(nucleus, ring, dt, first, force, A);
  const double k = chromatin_stiffness(p.nucleus, p.ecm.thickness);
  for (std::size_t i = 0; i < nucleus.size() / 2; ++i) {
    const auto a = static_cast<std::uint32_t>(first + i);
    const auto b = static_cast<std::uint32_t>(first + i + nucleus.size() / 2);
    const Vec2 e = nucleus.x[i + nucleus.size() / 2] - nucleus.x[i];
    const double l = e.norm();
    if (l <= 0.0) continue;
    const Vec2 t = e / l;
    const double T = spring_tension(k, l, diameter(p.nucleus));
    force[a] += T * t;
    force[b] -= T * t;
    A.directed.add(k * (p.nucleus.retardation_time + dt), {{a, t}, {b, -t}});
    const Vec2 n = perpendicular(t);
    if (T > 0.0 && dt > 0.0) A.directed.add(dt * T / l, {{a, n}, {b, -n}});
  }
}

double aspect_ratio(const CortexState& ring) {
  const Vec2 c = centroid(ring);
  Mat2 moments = Mat2::Zero(); // 12 times those of the triangles between the centroid and the segments
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring.x[i] - c;
    const Vec2 b = ring.x[ring.next(i)] - c;
    moments += 0.5 * cross(a, b) * (a * a.transpose() + b * b.transpose() + (a + b) * (a + b).transpose());
  }
  const Vec2 axes = Eigen::SelfAdjointEigenSolver<Mat2>(moments, Eigen::EigenvaluesOnly).eigenvalues();
  return std::sqrt(axes[1] / axes[0]);
}

} // namespace matrigrate
