#include "ecm/rows.hpp"

#include "body.hpp"
#include "ecm/deformation.hpp"
#include "ecm/stress.hpp"

#include <gtest/gtest.h>

#include <atomic>

using namespace matrigrate;

TEST(Rows, CoverAllParticlesInOrderAndAreLongOnALattice) {
  const Parameters p;
  const EcmState ecm = disc(p);
  const Reference ref(ecm, p.ecm);
  const Adjacency& pairs = ref.pairs();
  std::vector<Vec2> X_ij;
  for (std::uint32_t k = 0; k < pairs.pairs(); ++k) X_ij.push_back(ref.X_ij(k));
  std::size_t next = 0;
  std::size_t in_long_ones = 0;
  for (const ParticleRow& row : find_rows(pairs, X_ij)) {
    ASSERT_EQ(row.begin, next);
    ASSERT_LE(row.count, ParticleRow::longest);
    next += row.count;
    if (row.count > 20) in_long_ones += row.count;
    for (std::uint32_t t = 0; t < row.count; ++t) {
      const std::span<const std::uint32_t> partners = pairs.of(row.begin + t);
      ASSERT_EQ(partners.size(), row.partners);
      for (std::uint32_t k = 0; k < row.partners; ++k) {
        ASSERT_EQ(partners[k], pairs.index[row.entry + k] + t);
        ASSERT_LT((ecm.X[row.begin + t] - ecm.X[partners[k]] - ref.X_ij(row.entry + k)).norm(), 1e-9);
      }
    }
  }
  EXPECT_EQ(next, ecm.size());
  EXPECT_GT(in_long_ones, 17 * ecm.size() / 20);
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
    const auto equals_H = [&](std::size_t i, const Mat2& H) {
      const Mat2 expected =
          ecm.f[i] > 0.0 ? Mat2(deformation_gradient(ecm, ref, i) - Mat2::Identity()) : Mat2(Mat2::Zero());
      EXPECT_LT((H - expected).norm(), 1e-13);
      ++seen;
    };
    const auto equals_rate = [&](std::size_t i, const Mat2& rate) {
      EXPECT_LT((rate - (ecm.f[i] > 0.0 ? deformation_rate(ecm, ref, i) : Mat2(Mat2::Zero()))).norm(), 1e-13);
      ++seen;
    };
    row_gradients(
        ecm, ref, terms, u, [&](std::size_t i) { return ecm.displacement(i); }, equals_H);
    row_gradients(
        ecm, ref, terms, v, [&](std::size_t i) { return ecm.v[i]; }, equals_rate);
  });
  EXPECT_EQ(seen, 2 * ecm.size());
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
    sum_forces(terms, u, H, Q, stress, hourglass);
    sum_hourglass_moment(terms, u, H, moment);
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
