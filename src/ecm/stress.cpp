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

/// advance_stress_of with the shear modulus G at hand.
inline void advance_stress_of(EcmState& ecm, std::size_t i, const Mat2& L, const EcmParameters& p, double G,
                              double dt) {
  const double rho = ecm.rho[i] + dt * density_rate(ecm.rho[i], L);
  ecm.rho[i] = std::clamp(rho, p.density_min, p.density_max);
  ecm.S[i] += dt * jaumann_rate(ecm.S[i], L, G);
}

} // namespace

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

void add_elastic_forces(const EcmState& ecm, const EcmParameters& p, const Reference& ref, SolidFields& solid,
                        std::span<Vec2> force) {
  std::vector<Mat2>& F = solid.F;
  const std::size_t n = ecm.size();
  const double K = moduli(p).K;
  const double scale = hourglass_scale(ecm, p);
  const DegradationMoments& lattice = ref.lattice_moments();
  solid.u.resize(n);
  solid.H.resize(n);
  solid.PB.resize(n);
  F.resize(n);
  parallel_for(n, [&](std::size_t i) { solid.u.set(i, ecm.f[i] * ecm.displacement(i)); });
  ref.each_row([&](const RowTerms& terms) {
    const auto keep = [&](std::size_t i, const Mat2& H) {
      F[i] = Mat2::Identity() + H;
      solid.H.set(i, ecm.f[i] * H);
    };
    row_gradients(
        ecm, ref, terms, solid.u, [&](std::size_t i) { return ecm.displacement(i); }, keep);
  });
  ref.each_row([&](const RowTerms& terms) {
    RowTensors sum;
    sum_hourglass_moment(terms, solid.u, solid.H, sum);
    for (std::size_t t = 0; t < terms.row.count; ++t) {
      const std::size_t i = terms.row.begin + t;
      if (ecm.f[i] <= 0.0) {
        solid.PB.set(i, Mat2::Zero());
        continue;
      }
      const Mat2 P = piola_kirchhoff(cauchy_stress(ecm.rho[i], ecm.S[i], K), F[i]);
      const double per_own = 0.5 * scale / ecm.V0; // what is conjugate to the pair errors, through F_i
      if (ref.whole(i) && ecm.f[i] == 1.0) {
        const Mat2 own = (0.5 * lattice.wXX(0, 0)) * (F[i] - Mat2::Identity());
        solid.PB.set(i, ref.lattice_correction() * (P + per_own * (own + sum[t])));
        continue;
      }
      const DegradationMoments& m = ref.moments(i);
      const Mat2 own = 0.5 * (F[i] - Mat2::Identity()) * m.wXX - ecm.displacement(i) * m.wX.transpose();
      solid.PB.set(i, ecm.f[i] * (P + per_own * (own + sum[t])) * ref.B(i));
    }
  });
  ref.each_row([&](const RowTerms& terms) {
    RowVectors stress, hourglass;
    sum_forces(terms, solid.u, solid.H, solid.PB, stress, hourglass);
    for (std::size_t t = 0; t < terms.row.count; ++t) {
      const std::size_t i = terms.row.begin + t;
      const double f = ecm.f[i];
      if (f <= 0.0) continue;
      if (ref.whole(i) && f == 1.0) {
        const Vec2 of_hourglass = hourglass[t] - lattice.w * ecm.displacement(i);
        force[i] += p.thickness * (ecm.V0 * ecm.V0 * stress[t] + scale * of_hourglass);
        continue;
      }
      const DegradationMoments& m = ref.moments(i);
      const Vec2 of_stress = stress[t] + (solid.PB[i] / f) * m.grad_W;
      const Vec2 of_hourglass = hourglass[t] + 0.5 * (F[i] - Mat2::Identity()) * m.wX - ecm.displacement(i) * m.w;
      force[i] += p.thickness * f * (ecm.V0 * ecm.V0 * of_stress + scale * of_hourglass);
    }
  });
}

void advance_stress_of(EcmState& ecm, std::size_t i, const Mat2& L, const EcmParameters& p, double dt) {
  advance_stress_of(ecm, i, L, p, moduli(p).G, dt);
}

DensityBounds advance_stress(EcmState& ecm, const EcmParameters& p, const Reference& ref, SolidFields& solid,
                             double dt) {
  const double G = moduli(p).G;
  solid.v.resize(ecm.size());
  parallel_for(ecm.size(), [&](std::size_t i) { solid.v.set(i, ecm.f[i] * ecm.v[i]); });
  ref.each_row([&](const RowTerms& terms) {
    const auto advance = [&](std::size_t i, const Mat2& rate) {
      if (ecm.f[i] > 0.0) advance_stress_of(ecm, i, rate * solid.F[i].inverse(), p, G, dt);
    };
    row_gradients(
        ecm, ref, terms, solid.v, [&](std::size_t i) { return ecm.v[i]; }, advance);
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
