#include "ecm/loop/fluid.hpp"

#include "base/parallel.hpp"
#include "ecm/law/fluid.hpp"
#include "state/initial.hpp"

#include <algorithm>
#include <cmath>
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
  const double reach2 = kernel.support() * kernel.support();
  double sum = kernel.W(0.0);
  for (const std::uint32_t j : pairs.of(i))
    if (const double r2 = ecm.separation(i, j).squaredNorm(); r2 < reach2) sum += kernel.W(std::sqrt(r2));
  return fluid_pressure(ecm.f[i], ecm.V0 * sum / rho_lattice, moduli(p).K * ecm.stiffness(i));
}

void add_fluid_forces(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs,
                      std::vector<double>& pressure, std::span<Vec2> force) {
  const Kernel kernel(p.smoothing_length);
  const double reach2 = kernel.support() * kernel.support();
  const double rho_lattice = lattice_density(p);
  pressure.resize(ecm.size());
  parallel_for(ecm.size(), [&](std::size_t i) {
    pressure[i] = ecm.f[i] < 1.0 ? fluid_pressure(ecm, p, pairs, kernel, rho_lattice, i) : 0.0;
  });
  const double scale = p.thickness * ecm.V0 * ecm.V0;
  for (std::size_t i = 0; i < ecm.size(); ++i) { // few are under pressure: each pushes its neighbours off
    if (pressure[i] == 0.0) continue;
    for (const std::uint32_t j : pairs.of(i)) {
      const Vec2 x_ij = ecm.separation(i, j);
      const double r2 = x_ij.squaredNorm();
      if (r2 >= reach2) continue;
      const Vec2 push = scale * pressure[i] * kernel.W_slope(std::sqrt(r2)) * x_ij;
      force[i] -= push;
      force[j] += push;
    }
  }
}

} // namespace matrigrate
