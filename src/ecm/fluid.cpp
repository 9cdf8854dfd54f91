#include "ecm/fluid.hpp"

#include "base/parallel.hpp"
#include "ecm/material.hpp"
#include "state/initial.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace matrigrate {

double lattice_density(const EcmParameters& p) {
  const Kernel kernel(p.smoothing_length);
  double sum = 0.0;
  for (const Vec2& X : lattice_patch(p, kernel.support())) sum += kernel.W(X.norm());
  return particle_area(p) * sum;
}

double fluid_pressure(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs, const Kernel& kernel,
                      double rho_lattice, std::size_t i) {
  double sum = kernel.W(0.0);
  for (const std::uint32_t j : pairs.of(i)) sum += kernel.W(ecm.separation(i, j).norm());
  return (1.0 - ecm.f[i]) * std::max(0.0, pressure(ecm.V0 * sum / rho_lattice, moduli(p).K));
}

void add_fluid_forces(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs,
                      std::vector<double>& pressure, std::span<Vec2> force) {
  const Kernel kernel(p.smoothing_length);
  const double rho_lattice = lattice_density(p);
  pressure.resize(ecm.size());
  parallel_for(ecm.size(), [&](std::size_t i) {
    pressure[i] = ecm.f[i] < 1.0 ? fluid_pressure(ecm, p, pairs, kernel, rho_lattice, i) : 0.0;
  });
  std::vector<std::uint8_t> feels(ecm.size(), 0); // itself under pressure, or next to one that is
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (pressure[i] == 0.0) continue;
    feels[i] = 1;
    for (const std::uint32_t j : pairs.of(i)) feels[j] = 1;
  }
  parallel_for(ecm.size(), [&](std::size_t i) {
    if (!feels[i]) return;
    Vec2 sum = Vec2::Zero();
    for (const std::uint32_t j : pairs.of(i)) {
      const double p_ij = pressure[i] + pressure[j];
      if (p_ij == 0.0) continue;
      const Vec2 x_ij = ecm.separation(i, j);
      sum -= p_ij * kernel.W_slope(x_ij.norm()) * x_ij;
    }
    force[i] += p.thickness * ecm.V0 * ecm.V0 * sum;
  });
}

} // namespace matrigrate
