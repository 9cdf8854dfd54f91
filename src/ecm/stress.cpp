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

} // namespace

Mat2 piola_kirchhoff(const Mat2& sigma, const Mat2& F) {
  Mat2 cofactor; // J F^-T
  cofactor << F(1, 1), -F(1, 0), -F(0, 1), F(0, 0);
  return sigma * cofactor;
}

Vec2 hourglass_error(const EcmState& ecm, const Reference& ref, const std::vector<Mat2>& F, std::size_t i,
                     std::uint32_t k) {
  const std::uint32_t j = ref.pairs().index[k];
  return 0.5 * (F[i] + F[j]) * ref.X_ij(k) - (ref.X_ij(k) + ecm.displacement(i) - ecm.displacement(j));
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
                        SolidPlanes& planes, std::span<Vec2> force) {
  const std::size_t n = ecm.size();
  const double K = moduli(p).K;
  const double scale = hourglass_scale(ecm, p);
  planes.u.resize(n);
  planes.F.resize(n);
  planes.PB.resize(n);
  for (std::size_t i = 0; i < n; ++i) planes.u.set(i, ecm.displacement(i));
  gradients(ecm, ref, planes.u, F);
  for (std::size_t i = 0; i < n; ++i) {
    F[i] += Mat2::Identity();
    planes.F.set(i, F[i]);
  }
  ref.each_row(ecm, [&](const RowTerms& terms) {
    RowTensors moment;
    sum_hourglass_moment(terms, planes.u, planes.F, moment);
    for (std::size_t t = 0; t < terms.row.count; ++t) {
      const std::size_t i = terms.row.begin + t;
      Mat2 PB = Mat2::Zero();
      if (ecm.f[i] > 0.0) {
        const Mat2 conjugate = (0.5 * scale / ecm.V0) * moment[t]; // to the pair errors, through F_i
        PB = (piola_kirchhoff(cauchy_stress(ecm.rho[i], ecm.S[i], K), F[i]) + conjugate) * ref.B(i);
      }
      planes.PB.set(i, PB);
    }
  });
  ref.each_row(ecm, [&](const RowTerms& terms) {
    RowVectors sum;
    sum_forces(terms, planes.u, planes.F, planes.PB, ecm.V0 * ecm.V0, scale, sum);
    for (std::size_t t = 0; t < terms.row.count; ++t) {
      const std::size_t i = terms.row.begin + t;
      if (ecm.f[i] > 0.0) force[i] += p.thickness * ecm.f[i] * sum[t];
    }
  });
}

void advance_stress_of(EcmState& ecm, std::size_t i, const Mat2& L, const EcmParameters& p, double dt) {
  const double rho = ecm.rho[i] + dt * density_rate(ecm.rho[i], L);
  ecm.rho[i] = std::clamp(rho, p.density_min, p.density_max);
  ecm.S[i] += dt * jaumann_rate(ecm.S[i], L, moduli(p).G);
}

DensityBounds advance_stress(EcmState& ecm, const EcmParameters& p, const Reference& ref, const std::vector<Mat2>& F,
                             double dt) {
  VectorPlanes v;
  v.resize(ecm.size());
  for (std::size_t i = 0; i < ecm.size(); ++i) v.set(i, ecm.v[i]);
  std::vector<Mat2> rate;
  gradients(ecm, ref, v, rate);
  parallel_for(ecm.size(), [&](std::size_t i) {
    if (ecm.f[i] > 0.0) advance_stress_of(ecm, i, rate[i] * F[i].inverse(), p, dt);
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
