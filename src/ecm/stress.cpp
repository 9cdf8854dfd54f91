#include "ecm/stress.hpp"

#include "base/parallel.hpp"
#include "ecm/deformation.hpp"
#include "ecm/material.hpp"

#include <Eigen/LU>

#include <algorithm>

namespace matrigrate {

namespace {

/// a_hg E V_0^2, what is common to all c_ij [nN um^2].
double hourglass_scale(const EcmState& ecm, const EcmParameters& p) {
  return p.hourglass_weight * p.youngs_modulus * ecm.V0 * ecm.V0;
}

/// e_ij from what has been read of the pair.
inline Vec2 pair_error(const Mat2& F_i, const Mat2& F_j, const Vec2& X_ij, const Vec2& u_ij) {
  const Mat2 F = 0.5 * (F_i + F_j);
  return {(F(0, 0) - 1.0) * X_ij.x() + F(0, 1) * X_ij.y() - u_ij.x(),
          F(1, 0) * X_ij.x() + (F(1, 1) - 1.0) * X_ij.y() - u_ij.y()};
}

/// Stress conjugate to the pair errors through F_i: 1/V_0 sum_j 1/2 c_ij e_ij (x) X_ij, per unit f_i [kPa].
Mat2 hourglass_stress(const EcmState& ecm, double scale, const Reference& ref, const std::vector<Mat2>& F,
                      std::size_t i) {
  const Adjacency& pairs = ref.pairs();
  const Mat2 F_i = F[i];
  const Vec2 u_i = ecm.displacement(i);
  Mat2 sum = Mat2::Zero();
  for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
    const std::uint32_t j = pairs.index[k];
    const Vec2 u_ij = u_i - ecm.displacement(j);
    const Vec2 e = (ecm.f[j] * ref.W_over_r2(k)) * pair_error(F_i, F[j], ref.X_ij(k), u_ij);
    sum += e * ref.X_ij(k).transpose();
  }
  return (0.5 * scale / ecm.V0) * sum;
}

/// Force on particle i over t_z f_i [kPa um].
Vec2 elastic_force(const EcmState& ecm, double scale, const Reference& ref, const std::vector<Mat2>& F,
                   const std::vector<Mat2>& PB, std::size_t i) {
  const Adjacency& pairs = ref.pairs();
  const Mat2 F_i = F[i];
  const Mat2 PB_i = PB[i];
  const Vec2 u_i = ecm.displacement(i);
  Vec2 stress = Vec2::Zero();
  Vec2 hourglass = Vec2::Zero();
  for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
    const std::uint32_t j = pairs.index[k];
    if (ecm.f[j] <= 0.0) continue;
    const Vec2 u_ij = u_i - ecm.displacement(j);
    const Mat2 sum = PB_i + PB[j];
    stress += ecm.f[j] * Vec2(sum * ref.grad_W(k));
    hourglass += (ecm.f[j] * ref.W_over_r2(k)) * pair_error(F_i, F[j], ref.X_ij(k), u_ij);
  }
  return ecm.V0 * ecm.V0 * stress + scale * hourglass;
}

} // namespace

Mat2 piola_kirchhoff(const Mat2& sigma, const Mat2& F) {
  Mat2 cofactor; // J F^-T
  cofactor << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
  return sigma * cofactor;
}

Vec2 hourglass_error(const EcmState& ecm, const Reference& ref, const std::vector<Mat2>& F, std::size_t i,
                     std::uint32_t k) {
  const std::uint32_t j = ref.pairs().index[k];
  return pair_error(F[i], F[j], ref.X_ij(k), ecm.displacement(i) - ecm.displacement(j));
}

double hourglass_energy(const EcmState& ecm, const EcmParameters& p, const Reference& ref, const std::vector<Mat2>& F) {
  const double scale = hourglass_scale(ecm, p);
  return ordered_sum(ecm.size(), 0.0, [&](std::size_t i) {
    double sum = 0.0;
    for (std::uint32_t k = ref.pairs().first[i]; k < ref.pairs().first[i + 1]; ++k) {
      const double c_ij = scale * ecm.f[i] * ecm.f[ref.pairs().index[k]] * ref.W_over_r2(k);
      sum += 0.25 * c_ij * hourglass_error(ecm, ref, F, i, k).squaredNorm();
    }
    return sum;
  });
}

void add_elastic_forces(const EcmState& ecm, const EcmParameters& p, const Reference& ref, std::vector<Mat2>& F,
                        std::vector<Mat2>& PB, std::span<Vec2> force) {
  const std::size_t n = ecm.size();
  const double K = moduli(p).K;
  const double scale = hourglass_scale(ecm, p);
  F.resize(n);
  PB.resize(n);
  parallel_for(n, [&](std::size_t i) { F[i] = ecm.f[i] > 0.0 ? deformation_gradient(ecm, ref, i) : Mat2::Identity(); });
  parallel_for(n, [&](std::size_t i) {
    if (ecm.f[i] <= 0.0) return;
    const Mat2 P = piola_kirchhoff(cauchy_stress(ecm.rho[i], ecm.S[i], K), F[i]);
    PB[i] = (P + hourglass_stress(ecm, scale, ref, F, i)) * ref.B(i);
  });
  parallel_for(n, [&](std::size_t i) {
    if (ecm.f[i] > 0.0) force[i] += p.thickness * ecm.f[i] * elastic_force(ecm, scale, ref, F, PB, i);
  });
}

void advance_stress_of(EcmState& ecm, std::size_t i, const Mat2& L, const EcmParameters& p, double dt) {
  const double rho = ecm.rho[i] + dt * density_rate(ecm.rho[i], L);
  ecm.rho[i] = std::clamp(rho, p.density_min, p.density_max);
  ecm.S[i] += dt * jaumann_rate(ecm.S[i], L, moduli(p).G);
}

DensityBounds advance_stress(EcmState& ecm, const EcmParameters& p, const Reference& ref, const std::vector<Mat2>& F,
                             double dt) {
  parallel_for(ecm.size(), [&](std::size_t i) {
    if (ecm.f[i] <= 0.0) return;
    advance_stress_of(ecm, i, deformation_rate(ecm, ref, i) * F[i].inverse(), p, dt);
  });
  return count_density_bounds(ecm, p);
}

DensityBounds count_density_bounds(const EcmState& ecm, const EcmParameters& p) {
  DensityBounds bounds;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.rho[i] <= p.density_min) ++bounds.below;
    if (ecm.rho[i] >= p.density_max) ++bounds.above;
  }
  return bounds;
}

} // namespace matrigrate
