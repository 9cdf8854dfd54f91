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
    u.set(i, ecm.displacement(i));
    v.set(i, ecm.v[i]);
  }
  std::vector<Mat2> H, rate;
  gradients(ecm, ref, u, H);
  gradients(ecm, ref, v, rate);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    const bool solid = ecm.f[i] > 0.0;
    const Mat2 F = solid ? deformation_gradient(ecm, ref, i) : Mat2(Mat2::Identity());
    EXPECT_LT((H[i] + Mat2::Identity() - F).norm(), 1e-13);
    EXPECT_LT((rate[i] - (solid ? deformation_rate(ecm, ref, i) : Mat2(Mat2::Zero()))).norm(), 1e-13);
  }
}

TEST(Rows, ForcesEqualThoseOfSinglePairs) {
  const EcmParameters p;
  const EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  VectorPlanes u;
  TensorPlanes F, Q;
  u.resize(ecm.size());
  F.resize(ecm.size());
  Q.resize(ecm.size());
  std::vector<Mat2> gradient(ecm.size());
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    u.set(i, ecm.displacement(i));
    gradient[i] = deformation_gradient(ecm, ref, i);
    F.set(i, gradient[i]);
    Q.set(i, ecm.S[i]);
  }
  std::atomic<std::size_t> seen = 0;
  ref.each_row(ecm, [&](const RowTerms& terms) {
    RowVectors force;
    RowTensors moment;
    sum_forces(terms, u, F, Q, 2.0, 3.0, force);
    sum_hourglass_moment(terms, u, F, moment);
    for (std::size_t t = 0; t < terms.row.count; ++t, ++seen) {
      const std::size_t i = terms.row.begin + t;
      Vec2 expected = Vec2::Zero();
      Mat2 expected_moment = Mat2::Zero();
      for (std::uint32_t k = ref.pairs().first[i]; k < ref.pairs().first[i + 1]; ++k) {
        const std::uint32_t j = ref.pairs().index[k];
        const Vec2 e = hourglass_error(ecm, ref, gradient, i, k);
        expected += ecm.f[j] * (2.0 * (ecm.S[i] + ecm.S[j]) * ref.grad_W(k) + 3.0 * ref.W_over_r2(k) * e);
        expected_moment += ecm.f[j] * ref.W_over_r2(k) * e * ref.X_ij(k).transpose();
      }
      EXPECT_LT((force[t] - expected).norm(), 1e-13);
      EXPECT_LT((moment[t] - expected_moment).norm(), 1e-13);
    }
  });
  EXPECT_EQ(seen, ecm.size());
}
