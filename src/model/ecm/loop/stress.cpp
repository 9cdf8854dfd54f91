#include "ecm/loop/stress.hpp"

#include "base/parallel.hpp"
#include "ecm/law/material.hpp"
#include "ecm/loop/deformation.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
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

/// advance_stress_of for intact particles beside each other, from F - I at both ends of a step of dt.
/// @param S  as stress_of   @param after  of the first particle and those behind it
MATRIGRATE_SIMD
void advance_intact(std::size_t n, std::size_t begin, double* __restrict rho, double* __restrict S,
                    const TensorPlanes& before, const RowTensors& after, std::size_t from, const EcmParameters& p,
                    double G, double dt) {
  const double *xx = &before.xx.data()[begin], *xy = &before.xy.data()[begin];
  const double *yx = &before.yx.data()[begin], *yy = &before.yy.data()[begin];
  const double density_min = p.density_min, density_max = p.density_max, per_dt = 1.0 / dt;
  for (std::size_t t = 0; t < n; ++t) {
    const Tensor F{1.0 + xx[t], xy[t], yx[t], 1.0 + yy[t]};
    const Tensor rate{per_dt * (after.xx[from + t] - xx[t]), per_dt * (after.xy[from + t] - xy[t]),
                      per_dt * (after.yx[from + t] - yx[t]), per_dt * (after.yy[from + t] - yy[t])};
    const SolidStateOf<double> now =
        advanced({rho[t], stress_of(S, t)}, velocity_gradient(rate, F), G, dt, density_min, density_max);
    rho[t] = now.rho;
    S[4 * t] = now.S.xx;
    S[4 * t + 1] = now.S.yx;
    S[4 * t + 2] = now.S.xy;
    S[4 * t + 3] = now.S.yy;
  }
}

/// F - I of the particles of a row [-].
void displacement_gradients(const EcmState& ecm, const Reference& ref, const RowTerms& terms, const VectorPlanes& fu,
                            RowTensors& H) {
  row_gradients(
      ecm, ref, terms, fu, [&](std::size_t i) { return ecm.displacement(i); }, H);
}

/// Puts H times f into planes.
MATRIGRATE_SIMD
void keep_times(const double* f, const ParticleRow& row, const RowTensors& H, TensorPlanes& planes) {
  const std::size_t begin = row.begin, n = row.count;
  double* __restrict xx = planes.xx.data() + begin, * __restrict xy = planes.xy.data() + begin;
  double* __restrict yx = planes.yx.data() + begin, * __restrict yy = planes.yy.data() + begin;
  for (std::size_t t = 0; t < n; ++t) {
    xx[t] = f[t] * H.xx[t];
    xy[t] = f[t] * H.xy[t];
    yx[t] = f[t] * H.yx[t];
    yy[t] = f[t] * H.yy[t];
  }
}

/// Puts F - I of a row where the sums over neighbours read it, times f, and where partial particles have their F.
void keep_deformation(const EcmState& ecm, const ParticleRow& row, const RowTensors& H, SolidFields& solid) {
  keep_times(&ecm.f[row.begin], row, H, solid.H);
  if (all_intact({&ecm.f[row.begin], row.count})) return;
  for (std::size_t t = 0; t < row.count; ++t) {
    const std::size_t i = row.begin + t;
    if (ecm.f[i] < 1.0) solid.F_partial[i] = Mat2::Identity() + H[t]; // the identity in the fluid
  }
}

/// Adds the forces of plain particles.
/// @param x, X     positions and reference positions, x and y of a particle beside each other [um]
/// @param w        sum of w_ij over the lattice [1/um^4]   @param force  as x [nN]
MATRIGRATE_SIMD
void add_plain_forces(std::size_t n, const double* x, const double* X, const double* stress_x, const double* stress_y,
                      const double* hx, const double* hy, double w, double V0, double scale, double thickness,
                      double* __restrict force) {
  for (std::size_t t = 0; t < n; ++t) {
    const double of_hourglass_x = hx[t] - w * (x[2 * t] - X[2 * t]);
    const double of_hourglass_y = hy[t] - w * (x[2 * t + 1] - X[2 * t + 1]);
    force[2 * t] += thickness * (V0 * V0 * stress_x[t] + scale * of_hourglass_x);
    force[2 * t + 1] += thickness * (V0 * V0 * stress_y[t] + scale * of_hourglass_y);
  }
}

/// Displacements times f of particles begin .. end - 1.   @param x, X  as in add_plain_forces
MATRIGRATE_SIMD
void keep_displacements(std::size_t begin, std::size_t end, const double* x, const double* X, const double* f,
                        VectorPlanes& fu) {
  double* __restrict to_x = fu.x.data(), * __restrict to_y = fu.y.data();
  for (std::size_t i = begin; i < end; ++i) {
    to_x[i] = f[i] * (x[2 * i] - X[2 * i]);
    to_y[i] = f[i] * (x[2 * i + 1] - X[2 * i + 1]);
  }
}

/// Whether f or the displacement times f of any of these particles is not as kept.   @param x, X  as there
MATRIGRATE_SIMD
bool any_changed(std::size_t begin, std::size_t end, const double* x, const double* X, const double* f,
                 const SolidFields& solid) {
  const double *kept = solid.f.data(), *fu_x = solid.fu.x.data(), *fu_y = solid.fu.y.data();
  std::uint64_t changed = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const bool same = (f[i] == kept[i]) & (f[i] * (x[2 * i] - X[2 * i]) == fu_x[i])
                      & (f[i] * (x[2 * i + 1] - X[2 * i + 1]) == fu_y[i]);
    changed |= same ? 0U : 1U;
  }
  return changed != 0;
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
  each_block_with(
      n,
      [&](std::size_t begin, std::size_t end) {
        return anew || any_changed(begin, end, ecm.x[0].data(), ecm.X[0].data(), ecm.f.data(), solid);
      },
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Vec2 fu = ecm.f[i] * ecm.displacement(i);
          if (!anew && ecm.f[i] == solid.f[i] && fu == solid.fu[i]) continue;
          solid.f[i] = ecm.f[i];
          solid.fu.set(i, fu);
          changed.push_back(static_cast<std::uint32_t>(i));
        }
      });
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
    ref.each_stretch(ecm, terms.row, [&](std::size_t first, std::size_t end, bool plain) {
      if (plain) return;
      for (std::size_t i = first; i < end; ++i) {
        if (ecm.f[i] <= 0.0) {
          solid.PB.set(i, Mat2::Zero());
          continue;
        }
        const DegradationMoments& m = ref.moments(i);
        const Mat2 F = solid.F(ecm, i);
        const Mat2 P = piola_kirchhoff(cauchy_stress(ecm.rho[i], ecm.S[i], K), F);
        const Mat2 own = 0.5 * (F - Mat2::Identity()) * m.wXX - ecm.displacement(i) * m.wX.transpose();
        solid.PB.set(i, ecm.f[i] * (P + per_own * (own + sum[i - begin])) * ref.B(i));
      }
    });
  });
  ref.each_row([&](const RowTerms& terms) {
    RowVectors stress;
    sum_stress(terms, solid.PB, stress);
    ref.each_stretch(ecm, terms.row, [&](std::size_t first, std::size_t end, bool plain) {
      const std::size_t from = first - terms.row.begin;
      if (plain)
        return add_plain_forces(end - first, ecm.x[first].data(), ecm.X[first].data(), stress.x + from, stress.y + from,
                                solid.hourglass.x.data() + first, solid.hourglass.y.data() + first, lattice.w, ecm.V0,
                                scale, p.thickness, force[first].data());
      for (std::size_t i = first; i < end; ++i) {
        const double f = ecm.f[i];
        if (f <= 0.0) continue;
        const DegradationMoments& m = ref.moments(i);
        const Vec2 of_stress = stress[i - terms.row.begin] + (solid.PB[i] / f) * m.grad_W;
        const Vec2 of_hourglass =
            solid.hourglass[i] + 0.5 * (solid.F(ecm, i) - Mat2::Identity()) * m.wX - ecm.displacement(i) * m.w;
        force[i] += p.thickness * f * (ecm.V0 * ecm.V0 * of_stress + scale * of_hourglass);
      }
    });
  });
}

void advance_stress_of(EcmState& ecm, std::size_t i, const Mat2& L, const EcmParameters& p, double dt) {
  const SolidStateOf<double> now = advanced({ecm.rho[i], components(ecm.S[i])}, components(L),
                                            moduli(p).G * ecm.stiffness(i), dt, p.density_min, p.density_max);
  ecm.rho[i] = now.rho;
  ecm.S[i] = matrix(now.S);
}

DensityBounds advance_stress(EcmState& ecm, const EcmParameters& p, const Reference& ref, SolidFields& solid, double dt,
                             const std::function<void(std::size_t, std::size_t)>& move) {
  const double G = moduli(p).G;
  const bool uniform = ecm.E_ratio.empty();
  parallel_ranges(ecm.size(), light_grain, [&](std::size_t begin, std::size_t end) {
    if (move) move(begin, end);
    keep_displacements(begin, end, ecm.x[0].data(), ecm.X[0].data(), ecm.f.data(), solid.fu);
  });
  std::atomic<std::size_t> below = 0, above = 0;
  ref.each_row([&](const RowTerms& terms) {
    const std::size_t last = terms.row.begin + terms.row.count;
    RowTensors H;
    displacement_gradients(ecm, ref, terms, solid.fu, H);
    for (std::size_t i = terms.row.begin; i < last; ++i) {
      const std::size_t begin = i;
      while (uniform && i < last && ecm.f[i] == 1.0) ++i;
      if (i > begin)
        advance_intact(i - begin, begin, &ecm.rho[begin], ecm.S[begin].data(), solid.H, H, begin - terms.row.begin, p,
                       G, dt);
      if (i == last || ecm.f[i] <= 0.0) continue;
      const Mat2 F = solid.F(ecm, i);
      const Mat2 rate = (Mat2::Identity() + H[i - terms.row.begin] - F) / dt;
      advance_stress_of(ecm, i, velocity_gradient(rate, F), p, dt);
    }
    keep_deformation(ecm, terms.row, H, solid);
    const std::span<const double> rho = std::span(ecm.rho).subspan(terms.row.begin, terms.row.count);
    if (const auto n = std::ranges::count_if(rho, [&](double a) { return a <= p.density_min; }); n > 0)
      below += static_cast<std::size_t>(n);
    if (const auto n = std::ranges::count_if(rho, [&](double a) { return a >= p.density_max; }); n > 0)
      above += static_cast<std::size_t>(n);
  });
  return {below, above};
}

namespace {

/// Sums over the neighbours of a particle with r_ij = mean_stiffness() and w_ij = W_0,ij/|X_ij|^2.
struct HourglassSums {
  Vec2 force = Vec2::Zero();  ///< sum_j f_j r_ij w_ij e_ij [1/um^3]
  Mat2 moment = Mat2::Zero(); ///< sum_j f_j r_ij w_ij e_ij (x) X_ij [1/um^2]
};

/// @param H_i  F_i - I
HourglassSums hourglass_sums(const EcmState& ecm, const Reference& ref, const SolidFields& solid, const Mat2& H_i,
                             std::size_t i) {
  HourglassSums sums;
  const Vec2 u_i = ecm.displacement(i);
  for (std::uint32_t k = ref.pairs().first[i]; k < ref.pairs().first[i + 1]; ++k) {
    const std::uint32_t j = ref.pairs().index[k];
    const double f_j = ecm.f[j];
    if (f_j <= 0.0) continue;
    const Vec2& X = ref.X_ij(k);
    const Vec2 f_e = 0.5 * (f_j * H_i + solid.H[j]) * X - (f_j * u_i - solid.fu[j]); // H and fu stand times f
    const Vec2 pull = mean_stiffness(ecm, i, j) * ref.W_over_r2(k) * f_e;
    sums.force += pull;
    sums.moment += pull * X.transpose();
  }
  return sums;
}

} // namespace

void add_graded_elastic_forces(const EcmState& ecm, const EcmParameters& p, const Reference& ref, SolidFields& solid,
                               std::span<Vec2> force) {
  const double K = moduli(p).K;
  const double scale = hourglass_scale(ecm, p);
  const double per_own = 0.5 * scale / ecm.V0;
  parallel_for(ecm.size(), [&](std::size_t i) {
    if (ecm.f[i] <= 0.0) {
      solid.PB.set(i, Mat2::Zero());
      solid.hourglass.set(i, Vec2::Zero());
      return;
    }
    const Mat2 F = solid.F(ecm, i);
    const HourglassSums sums = hourglass_sums(ecm, ref, solid, F - Mat2::Identity(), i);
    const Mat2 P = piola_kirchhoff(cauchy_stress(ecm.rho[i], ecm.S[i], K * ecm.E_ratio[i]), F);
    solid.PB.set(i, ecm.f[i] * (P + per_own * sums.moment) * ref.B(i));
    solid.hourglass.set(i, sums.force);
  });
  ref.each_row([&](const RowTerms& terms) {
    RowVectors stress;
    sum_stress(terms, solid.PB, stress);
    for (std::size_t t = 0; t < terms.row.count; ++t) {
      const std::size_t i = terms.row.begin + t;
      const double f = ecm.f[i];
      if (f <= 0.0) continue;
      const Vec2 of_stress = stress[t] + (solid.PB[i] / f) * ref.moments(i).grad_W;
      force[i] += p.thickness * f * (ecm.V0 * ecm.V0 * of_stress + scale * solid.hourglass[i]);
    }
  });
}

} // namespace matrigrate
