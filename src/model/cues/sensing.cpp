#include "cues/sensing.hpp"

#include "cell/geometry.hpp"
#include "contact/proximity.hpp"
#include "ecm/law/material.hpp"
#include "sph/kernel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace matrigrate {

namespace {

/// Calls with_pair(i, k, W) for all particles i of the cortex and particles k of the matrix near it with f > above.
template <class WithPair>
void each_near(const CortexState& c, const EcmState& ecm, const Parameters& p, double above,
               const WithPair& with_pair) {
  const Kernel kernel(p.ecm.smoothing_length);
  const double reach2 = kernel.support() * kernel.support();
  const SegmentGrid grid(c, kernel.support());
  for (const std::uint32_t k : grid.candidates(ecm.x)) {
    if (ecm.f[k] <= above) continue;
    for (const std::uint32_t i : grid.near(ecm.x[k])) { // segment i begins at particle i
      const double r2 = (ecm.x[k] - c.x[i]).squaredNorm();
      if (r2 < reach2) with_pair(i, k, kernel.W(std::sqrt(r2)));
    }
  }
}

/// Weighted sums over the matrix around a particle of the cortex.
struct Surroundings {
  double weight = 0.0;
  double occupied = 0.0;
  double ligand = 0.0;
  Vec2 axis = Vec2::Zero(); ///< of the fibres, by twice their angle

  void add(double W, const EcmState& ecm, std::size_t k, const Parameters& p) {
    weight += W;
    if (!ecm.attractant.empty()) occupied += W * occupancy(ecm.attractant[k], p.cues.half_occupancy);
    ligand += W * ecm.f[k] * ecm.ligand_at(k);
    const double angle =
        ecm.fibre_direction.empty() ? p.fibres.direction_deg * std::numbers::pi / 180.0 : ecm.fibre_direction[k];
    axis += W * Vec2(std::cos(2.0 * angle), std::sin(2.0 * angle));
  }
};

std::vector<Surroundings> surroundings(const CortexState& c, const EcmState& ecm, const Parameters& p) {
  std::vector<Surroundings> all(c.size());
  each_near(c, ecm, p, -1.0, [&](std::uint32_t i, std::uint32_t k, double W) { all[i].add(W, ecm, k, p); });
  return all;
}

/// Mean of a law over directions all around, at the middles of steps of 5 degrees.
template <class Value>
double mean_over_angles(const Value& value) {
  constexpr int n = 72;
  double sum = 0.0;
  for (int k = 0; k < n; ++k) sum += value(std::numbers::pi * ((2.0 * k + 1.0) / n - 1.0));
  return sum / n;
}

} // namespace

std::vector<LawPlace> places_along(const CortexState& c, const EcmState& ecm, const Parameters& p, double time,
                                   bool matrix) {
  std::vector<LawPlace> places(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) places[i] = {.x = c.x[i].x(), .y = c.x[i].y(), .time = time};
  if (!matrix) return places;
  struct Sums {
    double solid = 0.0, density = 0.0, stiffness = 0.0, pressure = 0.0;
  };
  std::vector<Sums> sums(c.size());
  each_near(c, ecm, p, 0.0, [&](std::uint32_t i, std::uint32_t k, double W) {
    const double solid = W * ecm.f[k], E = solid * ecm.stiffness(k);
    sums[i].solid += solid;
    sums[i].density += solid * ecm.rho[k];
    sums[i].stiffness += E;
    sums[i].pressure += E * (ecm.rho[k] - 1.0);
  });
  constexpr double in_pascals = 1000.0; // of a kPa
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (sums[i].solid <= 0.0) continue;
    const double share = 1.0 / sums[i].solid;
    places[i].f_degr = std::min(1.0, ecm.V0 * sums[i].solid);
    places[i].density = share * sums[i].density;
    places[i].stiffness = in_pascals * p.ecm.youngs_modulus * share * sums[i].stiffness;
    places[i].pressure = in_pascals * moduli(p.ecm).K * share * sums[i].pressure;
  }
  return places;
}

double occupancy(double c, double K_d) { return c / (K_d + c); }

std::vector<double> along_cortex(const Law& law, const Cell& cell, const EcmState& ecm, const Parameters& p,
                                 double time) {
  const CortexState& c = cell.cortex;
  std::vector<double> values(c.size());
  const auto all = [&](double value) {
    std::ranges::fill(values, value);
    return values;
  };
  if (!law.varies()) return all(law({0.0, 0.0, 0.0, 0.0, 0.0}));
  const Vec2 centre = centre_of_mass(c);
  const bool senses = law.uses("occupancy") || law.uses("ligand") || law.uses("alignment");
  const std::vector<Surroundings> around = senses ? surroundings(c, ecm, p) : std::vector<Surroundings>(c.size());
  const bool all_around = !cell.polarization && law.uses("angle");
  std::vector<LawPlace> places;
  if (law.uses_place()) places = places_along(c, ecm, p, time, law.uses_matrix());
  if (all_around && !senses && !law.uses("kappa") && !law.uses_place())
    return all(mean_over_angles([&](double angle) { return law({angle, 0.0, 0.0, 0.0, 0.0}); }));
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vec2 outwards = c.x[i] - centre;
    const double direction = std::atan2(outwards.y(), outwards.x());
    const Surroundings& near = around[i];
    const double share = near.weight > 0.0 ? 1.0 / near.weight : 0.0;
    const double alignment = near.axis.dot(Vec2(std::cos(2.0 * direction), std::sin(2.0 * direction)));
    const auto value = [&](double angle) {
      return law({angle, curvature(c, i), share * near.occupied, share * near.ligand, share * alignment},
                 place_at(places, i));
    };
    values[i] = all_around          ? mean_over_angles(value)
                : cell.polarization ? value(std::remainder(direction - *cell.polarization, 2.0 * std::numbers::pi))
                                    : value(0.0);
  }
  return values;
}

std::vector<double> propensity(const Cell& cell, const EcmState& ecm, const Parameters& p, const Law& bias,
                               double time) {
  std::vector<double> factor = along_cortex(bias, cell, ecm, p, time);
  const double highest = std::ranges::max(factor); // so that no sum overflows
  if (highest <= 0.0) return {};
  double sum = 0.0;
  for (double& a : factor) sum += a /= highest;
  for (double& a : factor) a *= static_cast<double>(factor.size()) / sum;
  return factor;
}

} // namespace matrigrate
