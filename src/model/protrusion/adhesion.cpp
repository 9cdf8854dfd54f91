#include "protrusion/adhesion.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate {

namespace {

constexpr double rounding = 1e-9; // of the length of an adhesion that has just formed [um]

Kernel adhesion_kernel(const Parameters& p) { return Kernel(p.adhesion.spread * p.ecm.smoothing_length); }

} // namespace

double adhesion_force(double length, const AdhesionParameters& p, const Laws& laws, const LawPlace& place) {
  const double stretch = std::max(0.0, length - p.rest_length);
  return laws.adhesion_stiffness({stretch}, place) * stretch;
}

double adhesion_slope(double length, const AdhesionParameters& p, const Laws& laws, const LawPlace& place) {
  const double secant = laws.adhesion_stiffness({std::max(0.0, length - p.rest_length)}, place);
  if (!laws.adhesion_stiffness.uses("stretch")) return secant;
  constexpr double further = 1e-6; // [um]
  const auto force = [&](double at) { return adhesion_force(at, p, laws, place); };
  return std::max(secant, (force(length + further) - force(length)) / further);
}

double mature_pull(double f_mat, const Parameters& p) {
  constexpr double strands = 2.0;
  return strands * f_mat * p.actomyosin.force;
}

bool ruptures(double F, double f_mat, const Parameters& p) {
  return p.adhesion.rupture && F >= p.adhesion.rupture_ratio * mature_pull(f_mat, p);
}

const Vec2* anchor(const Phase& phase) {
  if (const auto* maturing = std::get_if<Maturing>(&phase)) return &maturing->anchor;
  if (const auto* contracting = std::get_if<Contracting>(&phase)) return &contracting->anchor;
  return nullptr;
}

Vec2* anchor(Phase& phase) {
  return const_cast<Vec2*>(anchor(static_cast<const Phase&>(phase))); // NOLINT: the phase is not const here
}

double adhesion_force(const CortexState& c, const Protrusion& protrusion, const AdhesionParameters& p, const Laws& laws,
                      const LawPlace& place) {
  const Vec2* point = anchor(protrusion.phase);
  return point == nullptr ? 0.0 : adhesion_force((*point - c.x[protrusion.centre]).norm(), p, laws, place);
}

double lengthening(const CortexState& c, const Protrusion& protrusion, const EcmState& ecm,
                   const PointWeights& weights) {
  const Vec2* point = anchor(protrusion.phase);
  if (point == nullptr) return 0.0;
  const Vec2 speed = interpolate(weights, ecm.v) - c.v[protrusion.centre];
  return speed.dot((*point - c.x[protrusion.centre]).normalized());
}

PointWeights hold_weights(const Vec2& point, const EcmState& ecm, const Parameters& p) {
  return solid_weights(ecm, adhesion_kernel(p), point);
}

PointWeights hold_weights(const Phase& phase, const EcmState& ecm, const Parameters& p) {
  if (anchor(phase) == nullptr) return {};
  const auto* maturing = std::get_if<Maturing>(&phase);
  return material_weights(ecm, adhesion_kernel(p),
                          maturing != nullptr ? maturing->held : std::get<Contracting>(phase).held);
}

Vec2 reference_position(const Vec2& point, const PointWeights& weights, const EcmState& ecm) {
  Vec2 X = point;
  for (std::size_t k = 0; k < weights.index.size(); ++k) X -= weights.weight[k] * ecm.displacement(weights.index[k]);
  return X;
}

std::vector<PointWeights> anchor_weights(const Cell& cell, const EcmState& ecm, const Parameters& p) {
  std::vector<PointWeights> weights(cell.protrusions.size());
  for (std::size_t n = 0; n < weights.size(); ++n) weights[n] = hold_weights(cell.protrusions[n].phase, ecm, p);
  return weights;
}

void add_adhesions(const Cell& cell, const EcmState& ecm, const AdhesionParameters& p, const Laws& laws,
                   std::span<const LawPlace> places, std::span<const PointWeights> weights, double dt,
                   std::uint32_t first, std::span<Vec2> force, NodeForces& on_matrix, DragSystem& A) {
  for (std::size_t n = 0; n < cell.protrusions.size(); ++n) {
    const Vec2* point = anchor(cell.protrusions[n].phase);
    if (point == nullptr) continue;
    const Vec2 L = *point - cell.cortex.x[cell.protrusions[n].centre];
    const double slack = p.rest_length - L.norm();
    if (slack > rounding && slack >= dt * lengthening(cell.cortex, cell.protrusions[n], ecm, weights[n])) continue;
    const LawPlace place = place_at(places, cell.protrusions[n].centre);
    const double F = -laws.adhesion_stiffness({std::max(0.0, -slack)}, place) * slack;
    const Vec2 e = L.normalized();
    const std::uint32_t tip = first + cell.protrusions[n].centre;
    force[tip] += F * e;
    for (std::size_t k = 0; k < weights[n].index.size(); ++k)
      on_matrix.add(weights[n].index[k], weights[n].weight[k] * (-F * e));
    const auto resist = [&](const Vec2& direction, double stiffness) {
      A.directed.add_entry(tip, direction);
      for (std::size_t k = 0; k < weights[n].index.size(); ++k)
        if (!ecm.clamped[weights[n].index[k]])
          A.directed.add_entry(weights[n].index[k], -weights[n].weight[k] * direction);
      A.directed.close(dt * stiffness);
    };
    resist(e, adhesion_slope(L.norm(), p, laws, place));
    if (F > 0.0) resist(perpendicular(e), F / L.norm());
  }
}

void move_anchors(Cell& cell, std::span<const Vec2> v, std::span<const PointWeights> weights, double dt) {
  for (std::size_t n = 0; n < cell.protrusions.size(); ++n)
    if (Vec2* point = anchor(cell.protrusions[n].phase)) *point += dt * interpolate(weights[n], v);
}

} // namespace matrigrate
