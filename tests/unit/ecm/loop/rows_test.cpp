#include "ecm/loop/rows.hpp"

#include "ecm/loop/deformation.hpp"
#include "ecm/loop/stress.hpp"
#include "unit/ecm/body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>

using namespace matrigrate;

namespace {

/// Every particle in one row, in order; every partner of every particle among those of its row, and no other.
/// @return the number of particles in long rows
std::size_t check_rows(const EcmState& ecm, const Reference& ref) {
  std::mutex one_at_a_time;
  std::vector<int> seen(ecm.size());
  std::size_t in_long_ones = 0;
  ref.each_row([&](const RowTerms& terms) {
    const std::scoped_lock lock(one_at_a_time);
    const ParticleRow& row = terms.row;
    EXPECT_LE(row.count, row.ragged ? ParticleRows::lanes : ParticleRow::longest);
    EXPECT_TRUE(row.ragged || row.count >= ParticleRows::lanes);
    if (row.count > 20) in_long_ones += row.count;
    for (std::uint32_t t = 0; t < row.count; ++t) {
      const std::size_t i = row.begin + t;
      ++seen[i];
      std::vector<std::uint32_t> partners;
      for (std::size_t k = 0; k < terms.partners.size(); ++k) {
        if (row.ragged && terms.has[ParticleRows::lanes * k + t] == 0.0) continue;
        const RowPartner& j = terms.partners[k];
        const auto partner = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + j.distance);
        partners.push_back(static_cast<std::uint32_t>(partner));
        EXPECT_LT((nearest_image(ecm.X[i] - ecm.X[partner], ecm.period_x) - 2.0 * Vec2(j.half_X, j.half_Y)).norm(),
                  1e-9);
      }
      const auto expected = ref.pairs().of(i);
      EXPECT_TRUE(std::ranges::equal(partners, expected)) << "particle " << i;
    }
  });
  EXPECT_EQ(std::ranges::count(seen, 1), static_cast<std::ptrdiff_t>(ecm.size()));
  return in_long_ones;
}

} // namespace

TEST(Rows, HoldEveryPartnerOfEveryParticleAndAreLongOnALattice) {
  Parameters p;
  for (const Lattice lattice : {Lattice::square, Lattice::hexagonal}) {
    p.ecm.lattice = lattice;
    const EcmState ecm = disc(p);
    EXPECT_GT(check_rows(ecm, Reference(ecm, p.ecm)), 17 * ecm.size() / 20);
  }
}

TEST(Rows, HoldEveryPartnerWhereTheMatrixRepeatsAndWhereItIsNarrow) {
  const EcmParameters p;
  for (const double width : {16.0, 24.0, 40.0}) {
    const EcmState periodic = strip(p, width, 20.0);
    check_rows(periodic, Reference(periodic, p));
    const EcmState free = rectangle(p, 0.5 * width, 20.0, 0.0);
    check_rows(free, Reference(free, p));
  }
}

TEST(Rows, GradientsEqualThoseOfSingleParticles) {
  const EcmParameters p;
  const EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  VectorPlanes u, v;
  u.resize(ecm.size());
  v.resize(ecm.size());
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    u.set(i, ecm.f[i] * ecm.displacement(i));
    v.set(i, ecm.f[i] * ecm.v[i]);
  }
  std::atomic<std::size_t> seen = 0;
  ref.each_row([&](const RowTerms& terms) {
    RowTensors H, rate;
    row_gradients(
        ecm, ref, terms, u, [&](std::size_t i) { return ecm.displacement(i); }, H);
    row_gradients(
        ecm, ref, terms, v, [&](std::size_t i) { return ecm.v[i]; }, rate);
    for (std::size_t t = 0; t < terms.row.count; ++t, ++seen) {
      const std::size_t i = terms.row.begin + t;
      const bool solid = ecm.f[i] > 0.0;
      const Mat2 F = solid ? deformation_gradient(ecm, ref, i) : Mat2(Mat2::Identity());
      EXPECT_LT((Mat2::Identity() + H[t] - F).norm(), 1e-13);
      EXPECT_LT((rate[t] - (solid ? deformation_rate(ecm, ref, i) : Mat2(Mat2::Zero()))).norm(), 1e-13);
    }
  });
  EXPECT_EQ(seen, ecm.size());
}

TEST(Rows, ForcesEqualThoseOfSinglePairs) {
  const EcmParameters p;
  const EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  VectorPlanes u;
  TensorPlanes H, Q;
  u.resize(ecm.size());
  H.resize(ecm.size());
  Q.resize(ecm.size());
  std::vector<Mat2> F(ecm.size());
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    u.set(i, ecm.f[i] * ecm.displacement(i));
    F[i] = deformation_gradient(ecm, ref, i);
    H.set(i, ecm.f[i] * (F[i] - Mat2::Identity()));
    Q.set(i, ecm.f[i] * ecm.S[i]);
  }
  std::atomic<std::size_t> seen = 0;
  ref.each_row([&](const RowTerms& terms) {
    RowVectors stress, hourglass;
    RowTensors moment;
    sum_hourglass(terms, u, H, moment, hourglass);
    sum_stress(terms, Q, stress);
    for (std::size_t t = 0; t < terms.row.count; ++t, ++seen) {
      const std::size_t i = terms.row.begin + t;
      Vec2 of_stress = Vec2::Zero(), of_hourglass = Vec2::Zero();
      Mat2 of_moment = Mat2::Zero();
      for (std::uint32_t k = ref.pairs().first[i]; k < ref.pairs().first[i + 1]; ++k) {
        const double f = ecm.f[ref.pairs().index[k]];
        const Vec2 e = hourglass_error(ecm, ref, F, i, k);
        of_stress += f * (ecm.S[i] + ecm.S[ref.pairs().index[k]]) * ref.grad_W(k);
        of_hourglass += f * ref.W_over_r2(k) * e;
        of_moment += f * ref.W_over_r2(k) * e * ref.X_ij(k).transpose();
      }
      const DegradationMoments& m = ref.moments(i);
      const Mat2 own = 0.5 * (F[i] - Mat2::Identity());
      const Vec2 u_i = ecm.displacement(i);
      EXPECT_LT((stress[t] + ecm.S[i] * m.grad_W - of_stress).norm(), 1e-13);
      EXPECT_LT((hourglass[t] + own * m.wX - u_i * m.w - of_hourglass).norm(), 1e-12);
      EXPECT_LT((moment[t] + own * m.wXX - u_i * m.wX.transpose() - of_moment).norm(), 1e-12);
    }
  });
  EXPECT_EQ(seen, ecm.size());
}
