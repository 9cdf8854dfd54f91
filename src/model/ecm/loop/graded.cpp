#include "ecm/loop/graded.hpp"

#include "base/parallel.hpp"

namespace matrigrate {

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
