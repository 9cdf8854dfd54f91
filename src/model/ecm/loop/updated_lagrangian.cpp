#include "ecm/loop/updated_lagrangian.hpp"

#include "base/parallel.hpp"
#include "ecm/law/material.hpp"
#include "sph/kernel.hpp"

#include <vector>

namespace matrigrate {

void add_current_elastic_forces(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs,
                                std::span<Vec2> force) {
  const Kernel kernel(p.smoothing_length);
  const double K = moduli(p).K;
  parallel_for(ecm.size(), [&](std::size_t i) {
    const Mat2 sigma_i = ecm.f[i] * cauchy_stress(ecm.rho[i], ecm.S[i], K * ecm.stiffness(i));
    Vec2 sum = Vec2::Zero();
    for (const std::uint32_t j : pairs.of(i)) {
      const Vec2 x_ij = ecm.separation(i, j);
      const Mat2 sigma_j = ecm.f[j] * cauchy_stress(ecm.rho[j], ecm.S[j], K * ecm.stiffness(j));
      const double V_i_V_j = ecm.V0 * ecm.V0 / (ecm.rho[i] * ecm.rho[j]);
      sum += V_i_V_j * kernel.W_slope(x_ij.norm()) * ((sigma_i + sigma_j) * x_ij);
    }
    force[i] += p.thickness * sum;
  });
}

Mat2 current_velocity_gradient(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs, std::size_t i) {
  const Kernel kernel(p.smoothing_length);
  Mat2 L = Mat2::Zero();
  for (const std::uint32_t j : pairs.of(i)) {
    const Vec2 x_ij = ecm.separation(i, j);
    L += ecm.V0 / ecm.rho[j] * kernel.W_slope(x_ij.norm()) * (ecm.v[j] - ecm.v[i]) * x_ij.transpose();
  }
  return L;
}

DensityBounds advance_current_stress(EcmState& ecm, const EcmParameters& p, const Adjacency& pairs, double dt) {
  std::vector<Mat2> L(ecm.size(), Mat2::Zero()); // of all particles before any density changes
  parallel_for(ecm.size(), [&](std::size_t i) {
    if (ecm.f[i] > 0.0) L[i] = current_velocity_gradient(ecm, p, pairs, i);
  });
  parallel_for(ecm.size(), [&](std::size_t i) {
    if (ecm.f[i] > 0.0) advance_stress_of(ecm, i, L[i], p, dt);
  });
  return count_density_bounds(ecm, p);
}

} // namespace matrigrate
