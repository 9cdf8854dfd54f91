#include "ecm/loop/stress.hpp"

#include "base/parallel.hpp"
#include "ecm/law/material.hpp"
#include "ecm/loop/deformation.hpp"
#include "ecm/loop/graded.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace matrigrate {

namespace {

/// Deviatoric stress of particle t of a row.   @param S  components xx, yx, xy, yy one after the other, by particles
[[gnu::always_inline]] inline Tensor stress_of(const double* S, std::size_t t) {
  return {S[4 * t], S[4 * t + 2], S[4 * t + 1], S[4 * t + 3]};
}

/// P_i B_i of all particles of a row as if they were plain: c (J sigma F^-T + a (F - I) + b moment).
/// @param S  as stress_of
MATRIGRATE_SIMD
void corrected_stress(std::size_t n, std::size_t begin, const double* rho, const double* S, const TensorPlanes& H,
                      const RowTensors& moment, double K, double a, double b, double c, TensorPlanes& PB) {
  const double *Hxx = &H.xx.data()[begin], *Hxy = &H.xy.data()[begin];
  const double *Hyx = &H.yx.data()[begin], *Hyy = &H.yy.data()[begin];
  double* __restrict xx = PB.xx.data() + begin, * __restrict xy = PB.xy.data() + begin;
  double* __restrict yx = PB.yx.data() + begin, * __restrict yy = PB.yy.data() + begin;
  for (std::size_t t = 0; t < n; ++t) {
    const Tensor F{1.0 + Hxx[t], Hxy[t], Hyx[t], 1.0 + Hyy[t]};
    const Tensor P = piola_kirchhoff(cauchy_stress(rho[t], stress_of(S, t), K), F);
    xx[t] = c * (P.xx + (a * Hxx[t] + b * moment.xx[t]));
    xy[t] = c * (P.xy + (a * Hxy[t] + b * moment.xy[t]));
    yx[t] = c * (P.yx + (a * Hyx[t] + b * moment.yx[t]));
    yy[t] = c * (P.yy + (a * Hyy[t] + b * moment.yy[t]));
  }
}

/// Density and stress of a row after dt, all of its particles intact.
struct Advanced {
  double rho[ParticleRow::longest];
  RowTensors S;
};

/// advance_stress_of for the particles of a row, from their rates of deformation.   @param S  as stress_of
MATRIGRATE_SIMD
void advance_row(std::size_t n, std::size_t begin, const double* rho, const double* S, const TensorPlanes& H,
                 const RowTensors& rate, const EcmParameters& p, double G, double dt, Advanced& to) {
  const double *Hxx = &H.xx.data()[begin], *Hxy = &H.xy.data()[begin];
  const double *Hyx = &H.yx.data()[begin], *Hyy = &H.yy.data()[begin];
  const double density_min = p.density_min, density_max = p.density_max;
  for (std::size_t t = 0; t < n; ++t) {
    const Tensor F{1.0 + Hxx[t], Hxy[t], Hyx[t], 1.0 + Hyy[t]};
    const Tensor L = velocity_gradient(Tensor{rate.xx[t], rate.xy[t], rate.yx[t], rate.yy[t]}, F);
    const SolidStateOf<double> now = advanced({rho[t], stress_of(S, t)}, L, G, dt, density_min, density_max);
    to.rho[t] = now.rho;
    to.S.xx[t] = now.S.xx;
    to.S.xy[t] = now.S.xy;
    to.S.yx[t] = now.S.yx;
    to.S.yy[t] = now.S.yy;
  }
}

/// F - I of the particles of a row [-].
void displacement_gradients(const EcmState& ecm, const Reference& ref, const RowTerms& terms, const VectorPlanes& fu,
                            RowTensors& H) {
  row_gradients(
      ecm, ref, terms, fu, [&](std::size_t i) { return ecm.displacement(i); }, H);
}

/// Puts F - I of a row where the sums over neighbours read it, times f, and where partial particles have their F.
void keep_deformation(const EcmState& ecm, const ParticleRow& row, const RowTensors& H, SolidFields& solid) {
  for (std::size_t t = 0; t < row.count; ++t) {
    const std::size_t i = row.begin + t;
    const double f = ecm.f[i];
    solid.H.xx[i] = f * H.xx[t], solid.H.xy[i] = f * H.xy[t];
    solid.H.yx[i] = f * H.yx[t], solid.H.yy[i] = f * H.yy[t];
  }
  for (std::size_t t = 0; t < row.count; ++t) {
    const std::size_t i = row.begin + t;
    if (ecm.f[i] < 1.0) solid.F_partial[i] = Mat2::Identity() + H[t]; // the identity in the fluid
  }
}

/// Rates of deformation [1/s] of a row from the gradients at both ends of a step, where it is intact.
MATRIGRATE_SIMD
void rates_of_row(std::size_t n, std::size_t begin, const TensorPlanes& before, const RowTensors& after, double per_dt,
                  RowTensors& rate) {
  const double *xx = &before.xx.data()[begin], *xy = &before.xy.data()[begin];
  const double *yx = &before.yx.data()[begin], *yy = &before.yy.data()[begin];
  for (std::size_t t = 0; t < n; ++t) {
    rate.xx[t] = per_dt * (after.xx[t] - xx[t]);
    rate.xy[t] = per_dt * (after.xy[t] - xy[t]);
    rate.yx[t] = per_dt * (after.yx[t] - yx[t]);
    rate.yy[t] = per_dt * (after.yy[t] - yy[t]);
  }
}

} // namespace

double hourglass_scale(const EcmState& ecm, const EcmParameters& p) {
  return p.hourglass_weight * p.youngs_modulus * ecm.V0 * ecm.V0;
}

void SolidFields::resize(std::size_t n) {
  fu.resize(n);
  H.resize(n);
  hourglass.resize(n);
  PB.resize(n);
  F_partial.resize(n, Mat2::Identity());
}

SolidFields undeformed(std::size_t n) {
  SolidFields solid;
  solid.resize(n);
  solid.f.assign(n, 1.0);
  return solid;
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
      const std::uint32_t j = ref.pairs().index[k];
      const double c_ij = scale * ecm.f[i] * ecm.f[j] * ref.W_over_r2(k) * mean_stiffness(ecm, i, j);
      sum += 0.25 * c_ij * hourglass_error(ecm, ref, F, i, k).squaredNorm();
    }
    return sum;
  });
}

void follow_deformation(const EcmState& ecm, const Reference& ref, SolidFields& solid) {
  const std::size_t n = ecm.size();
  const bool anew = solid.f.size() != n;
  solid.resize(n);
  solid.f.resize(n);
  std::vector<std::uint32_t> changed;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 fu = ecm.f[i] * ecm.displacement(i);
    if (!anew && ecm.f[i] == solid.f[i] && fu == solid.fu[i]) continue;
    solid.f[i] = ecm.f[i];
    solid.fu.set(i, fu);
    changed.push_back(static_cast<std::uint32_t>(i));
  }
  if (changed.empty()) return;
  constexpr std::size_t few = 16; // one particle in so many
  std::vector<std::uint8_t> stale(n, few * changed.size() < n ? 0 : 1);
  if (few * changed.size() < n)
    for (const std::uint32_t i : changed) {
      stale[i] = 1;
      for (const std::uint32_t j : ref.pairs().of(i)) stale[j] = 1;
    }
  ref.each_row([&](const RowTerms& terms) {
    const auto first = stale.begin() + terms.row.begin;
    constexpr std::size_t lanes = ParticleRows::lanes;
    std::size_t t = 0;
    while (t < terms.row.count) { // stretches of stale particles, as long as sums are made at once, or longer
      const auto end = first + terms.row.count;
      const auto begin = std::find(first + static_cast<std::ptrdiff_t>(t), end, 1);
      if (begin == end) break;
      const auto from = static_cast<std::size_t>(begin - first);
      t = static_cast<std::size_t>(std::find(begin, end, 0) - first);
      RowTensors H;
      RowTerms stretch = terms;
      if (!terms.row.ragged) {
        t = std::min<std::size_t>(terms.row.count, std::max(t, from + lanes));
        stretch.row.begin += static_cast<std::uint32_t>(std::min(from, t - lanes));
        stretch.row.count = static_cast<std::uint32_t>(terms.row.begin + t - stretch.row.begin);
      } else {
        t = terms.row.count;
      }
      displacement_gradients(ecm, ref, stretch, solid.fu, H);
      keep_deformation(ecm, stretch.row, H, solid);
    }
  });
}

void add_elastic_forces(const EcmState& ecm, const EcmParameters& p, const Reference& ref, SolidFields& solid,
                        std::span<Vec2> force) {
  const double K = moduli(p).K;
  const double scale = hourglass_scale(ecm, p);
  const DegradationMoments& lattice = ref.lattice_moments();
  follow_deformation(ecm, ref, solid);
  if (!ecm.E_ratio.empty()) return add_graded_elastic_forces(ecm, p, ref, solid, force);
  ref.each_row([&](const RowTerms& terms) {
    RowTensors sum;
    RowVectors hourglass;
    sum_hourglass(terms, solid.fu, solid.H, sum, hourglass);
    std::copy_n(hourglass.x, terms.row.count, solid.hourglass.x.data() + terms.row.begin);
    std::copy_n(hourglass.y, terms.row.count, solid.hourglass.y.data() + terms.row.begin);
    const double per_own = 0.5 * scale / ecm.V0; // what is conjugate to the pair errors, through F_i
    const std::size_t begin = terms.row.begin;
    corrected_stress(terms.row.count, begin, &ecm.rho[begin], ecm.S[begin].data(), solid.H, sum, K,
                     per_own * 0.5 * lattice.wXX(0, 0), per_own, ref.lattice_correction(), solid.PB);
    for (std::size_t t = 0; t < terms.row.count; ++t) {
      const std::size_t i = begin + t;
      if (ref.plain(ecm, i)) continue;
      if (ecm.f[i] <= 0.0) {
        solid.PB.set(i, Mat2::Zero());
        continue;
      }
      const DegradationMoments& m = ref.moments(i);
      const Mat2 F = solid.F(ecm, i);
      const Mat2 P = piola_kirchhoff(cauchy_stress(ecm.rho[i], ecm.S[i], K), F);
      const Mat2 own = 0.5 * (F - Mat2::Identity()) * m.wXX - ecm.displacement(i) * m.wX.transpose();
      solid.PB.set(i, ecm.f[i] * (P + per_own * (own + sum[t])) * ref.B(i));
    }
  });
  ref.each_row([&](const RowTerms& terms) {
    RowVectors stress;
    sum_stress(terms, solid.PB, stress);
    for (std::size_t t = 0; t < terms.row.count; ++t) {
      const std::size_t i = terms.row.begin + t;
      const double f = ecm.f[i];
      if (f <= 0.0) continue;
      if (ref.plain(ecm, i)) {
        const Vec2 of_hourglass = solid.hourglass[i] - lattice.w * ecm.displacement(i);
        force[i] += p.thickness * (ecm.V0 * ecm.V0 * stress[t] + scale * of_hourglass);
        continue;
      }
      const DegradationMoments& m = ref.moments(i);
      const Vec2 of_stress = stress[t] + (solid.PB[i] / f) * m.grad_W;
      const Vec2 of_hourglass =
          solid.hourglass[i] + 0.5 * (solid.F(ecm, i) - Mat2::Identity()) * m.wX - ecm.displacement(i) * m.w;
      force[i] += p.thickness * f * (ecm.V0 * ecm.V0 * of_stress + scale * of_hourglass);
    }
  });
}

void advance_stress_of(EcmState& ecm, std::size_t i, const Mat2& L, const EcmParameters& p, double dt) {
  const SolidStateOf<double> now = advanced({ecm.rho[i], components(ecm.S[i])}, components(L),
                                            moduli(p).G * ecm.stiffness(i), dt, p.density_min, p.density_max);
  ecm.rho[i] = now.rho;
  ecm.S[i] = matrix(now.S);
}

DensityBounds advance_stress(EcmState& ecm, const EcmParameters& p, const Reference& ref, SolidFields& solid,
                             double dt) {
  const double G = moduli(p).G;
  const bool uniform = ecm.E_ratio.empty();
  parallel_for(ecm.size(), [&](std::size_t i) { solid.fu.set(i, ecm.f[i] * ecm.displacement(i)); });
  ref.each_row([&](const RowTerms& terms) {
    const std::size_t begin = terms.row.begin;
    const std::size_t n = terms.row.count;
    RowTensors H, rate;
    displacement_gradients(ecm, ref, terms, solid.fu, H);
    rates_of_row(n, begin, solid.H, H, 1.0 / dt, rate);
    Advanced to;
    advance_row(n, begin, &ecm.rho[begin], ecm.S[begin].data(), solid.H, rate, p, G, dt, to);
    for (std::size_t t = 0; t < n; ++t) {
      const std::size_t i = begin + t;
      if (ecm.f[i] == 1.0 && uniform) {
        ecm.rho[i] = to.rho[t];
        ecm.S[i] = to.S[t];
      } else if (ecm.f[i] > 0.0) {
        const Mat2 F = solid.F(ecm, i);
        advance_stress_of(ecm, i, velocity_gradient(Mat2((Mat2::Identity() + H[t] - F) / dt), F), p, dt);
      }
    }
    keep_deformation(ecm, terms.row, H, solid);
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
