#include "protrusion/adhesion.hpp"

#include "base/random.hpp"
#include "parameters/laws/law.hpp"
#include "scene.hpp"
#include "statistics/distributions.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

namespace {

/// A contracting protrusion to the right, its adhesion stretched by 0.3 um and out of line.
Scene pulling(const Parameters& p) {
  Scene s = cell_in_matrix(p);
  const Vec2 anchor = s.cell.cortex.x[0] + 5.3 * Vec2(std::cos(0.4), std::sin(0.4));
  add_protrusion(s, 0, Contracting{.anchor = anchor, .f_mat = 0.8, .held = anchor}); // the matrix is at rest
  return s;
}

Assembled adhesions(const Scene& s, const Parameters& p) {
  const std::vector<PointWeights> weights = anchor_weights(s.cell, s.ecm, p);
  return assemble(s.nodes(), [&](std::span<Vec2> force, DragSystem& A) {
    NodeForces on_matrix;
    add_adhesions(s.cell, s.ecm, p.adhesion, Laws(p), {}, weights, time_step, s.first(), force, on_matrix, A);
    on_matrix.add_to(force);
  });
}

/// Eq. 7.
Law r_off(const AdhesionParameters& adhesion = {}) {
  Parameters p;
  p.adhesion = adhesion;
  return {"laws.disassembly_rate", p};
}

} // namespace

TEST(AdhesionForce, PullsOnlyBeyondItsRestLength) {
  const Parameters p;
  EXPECT_DOUBLE_EQ(adhesion_force(5.3, p.adhesion, Laws(p)), 0.6);
  EXPECT_EQ(adhesion_force(5.0, p.adhesion, Laws(p)), 0.0);
  EXPECT_EQ(adhesion_force(0.0, p.adhesion, Laws(p)), 0.0);
}

// Heck et al. 2020, Fig 4 (from Table 1): unloaded and loaded adhesions of full and half maturation.
TEST(DisassemblyRate, HasTheValuesOfEquationSeven) {
  const Law rate = r_off();
  EXPECT_NEAR(rate({0.0, 1.0, 0.0}), 0.200278, 1e-9);
  EXPECT_NEAR(rate({0.6, 1.0, 0.0}), 2.78e-4 + 0.2 * 6.14421e-6, 1e-9);
  EXPECT_NEAR(rate({0.3, 1.0, 0.0}), 2.78e-4 + 0.2 * 2.47875e-3, 1e-8);
  EXPECT_NEAR(rate({0.3, 0.5, 0.0}), rate({0.6, 1.0, 0.0}), 1e-15);
  EXPECT_NEAR(1.0 / rate({0.6, 1.0, 0.0}) / 3600.0, 0.995, 0.001); // an hour under full load
}

TEST(DisassemblyRate, FallsWithTheForceTowardsItsLeast) {
  AdhesionParameters p;
  const Law law = r_off(p);
  double last = 1.0;
  for (double F = 0.0; F < 1.5; F += 0.05) {
    const double rate = law({F, 0.9, 0.0});
    EXPECT_LT(rate, last);
    EXPECT_GT(rate, p.r_off_min);
    last = rate;
  }
  p.zeta_diss = 0.0;
  EXPECT_EQ(r_off(p)({0.1, 0.5, 0.0}), r_off(p)({1.0, 0.9, 0.0}));
}

TEST(Rupture, HappensAtItsShareOfTheMatureForceWhereSwitchedOn) {
  Parameters p;
  EXPECT_FALSE(ruptures(10.0, 0.5, p));
  p.adhesion.rupture = true;
  EXPECT_FALSE(ruptures(0.599, 0.5, p)); // 0.5 x 0.6 nN in each of two strands
  EXPECT_TRUE(ruptures(0.601, 0.5, p));
  p.adhesion.rupture_ratio = 0.5; // at the force of one
  EXPECT_FALSE(ruptures(0.299, 0.5, p));
  EXPECT_TRUE(ruptures(0.301, 0.5, p));
}

TEST(Lifetimes, OfAdhesionsUnderConstantForceAreExponential) {
  for (const double F : {0.1, 0.2, 0.3}) {
    const double rate = r_off()({F, 1.0, 0.0});
    const double probability = event_probability(rate, time_step);
    std::vector<double> lifetimes;
    for (std::uint32_t id = 1; id <= 2000; ++id) {
      std::uint64_t step = 1;
      while (uniform(11, Purpose::disassembly, step, id) >= probability) ++step;
      // within the step in which it happens any moment is as likely as for a rate: take it by the same law
      const double u = uniform(12, Purpose::test, step, id);
      lifetimes.push_back((static_cast<double>(step) - 1.0) * time_step - std::log1p(-u * probability) / rate);
    }
    EXPECT_LT(kolmogorov_smirnov_exponential(lifetimes, rate), one_in_a_hundred) << F;
  }
}

TEST(Adhesions, PullTipAndSolidTogether) {
  const Parameters p = small_matrix();
  const Scene s = pulling(p);
  const std::vector<Vec2> force = adhesions(s, p).force;
  const Vec2& pull = force[s.node(0)];
  EXPECT_NEAR(pull.norm(), 0.6, 1e-9);
  EXPECT_GT(pull.dot(Vec2(std::cos(0.4), std::sin(0.4))), 0.6 - 1e-9);
  EXPECT_LT(net_force(force).norm(), 1e-12);
  for (std::size_t i = 1; i < s.cell.cortex.size(); ++i) EXPECT_EQ(force[s.node(i)].norm(), 0.0);
}

TEST(Adhesions, AreNothingWhileSlack) {
  const Parameters p = small_matrix();
  Scene s = pulling(p);
  std::get<Contracting>(s.cell.protrusions[0].phase).anchor = s.cell.cortex.x[0] + Vec2(4.9, 0.0);
  const Assembled a = adhesions(s, p);
  EXPECT_EQ(largest(a.force), 0.0);
  EXPECT_EQ(a.A.directed.size(), 0U);
}

// Otherwise the first step would stretch a new adhesion by all that its tip moves.
TEST(Adhesions, ResistFromTheirFirstStepAndWhereTheyBecomeTaut) {
  const Parameters p = small_matrix();
  Scene s = pulling(p);
  const Vec2 e(1.0, 0.0);
  const auto at = [&](double length, double tip_speed) {
    std::get<Contracting>(s.cell.protrusions[0].phase).anchor = s.cell.cortex.x[0] + length * e;
    s.cell.cortex.v[0] = -tip_speed * e;
    return adhesions(s, p);
  };
  const auto resistance = [&](const Assembled& a) { // to the tip's motion along the adhesion [nN s/um]
    std::vector<Vec2> v(a.force.size(), Vec2::Zero());
    v[s.node(0)] = e;
    return drag_force(a.A, v)[s.node(0)].x();
  };
  EXPECT_NEAR(resistance(at(5.0 - 1e-12, 0.0)), time_step * p.adhesion.stiffness, 1e-9) << "it has just formed";
  const Assembled soon = at(4.9, 0.3); // taut after 0.33 s of 0.4 s
  EXPECT_NEAR(resistance(soon), time_step * p.adhesion.stiffness, 1e-9);
  EXPECT_NEAR(soon.force[s.node(0)].x(), -0.1 * p.adhesion.stiffness, 1e-9)
      << "so that it bears 2 (0.12 - 0.1) nN then";
  EXPECT_EQ(at(4.9, 0.2).A.directed.size(), 0U) << "still slack then";
}

TEST(Adhesions, AreFullyImplicit) {
  const Parameters p = small_matrix();
  Scene s = pulling(p);
  const Assembled a = adhesions(s, p);
  std::vector<Vec2> v(a.force.size(), Vec2::Zero());
  v[s.node(0)] = Vec2(-0.003, 0.005); // the tip moves, the matrix rests
  const Vec2 drag = drag_force(a.A, v)[s.node(0)];
  constexpr double h = 1e-5;
  s.cell.cortex.x[0] += h * v[s.node(0)];
  const Vec2 rate = (adhesions(s, p).force[s.node(0)] - a.force[s.node(0)]) / h;
  EXPECT_LT((drag + time_step * rate).norm(), 1e-6 * drag.norm());
}

TEST(Adhesions, ConserveMomentumInTheirDrag) {
  const Parameters p = small_matrix();
  const Scene s = pulling(p);
  const DragSystem A = adhesions(s, p).A;
  const std::vector<Vec2> v = stirred(A.size());
  EXPECT_LT(net_force(drag_force(A, v)).norm(), 1e-12);
  EXPECT_GT(power(drag_force(A, v), v), 0.0);
}

TEST(Anchors, AreCarriedByTheSolid) {
  const Parameters p = small_matrix();
  Scene s = pulling(p);
  const Vec2 before = *anchor(s.cell.protrusions[0].phase);
  Mat2 L;
  L << 0.001, 0.002, -0.001, 0.0005;
  for (std::size_t k = 0; k < s.ecm.size(); ++k) s.ecm.v[k] = Vec2(0.01, 0.02) + L * (s.ecm.x[k] - before);
  move_anchors(s.cell, s.ecm.v, anchor_weights(s.cell, s.ecm, p), time_step);
  const double off_centre = 0.05; // [um] the weights' mean position, off the lattice points
  EXPECT_LT((*anchor(s.cell.protrusions[0].phase) - before - time_step * Vec2(0.01, 0.02)).norm(),
            time_step * L.norm() * off_centre);
}

TEST(Anchors, BelongToMaturingAndContractingProtrusions) {
  const Vec2 at(1.0, 2.0);
  EXPECT_EQ(anchor(Phase(Growing{at})), nullptr);
  EXPECT_EQ(anchor(Phase(Finishing{0.3})), nullptr);
  EXPECT_EQ(*anchor(Phase(Maturing{at, at, 0})), at);
  EXPECT_EQ(*anchor(Phase(Contracting{at, 0.3})), at);
}

// An adhesion that hangs on matter keeps its particles and their weights while the gel moves and strains under it.
TEST(Hold, OnMatterKeepsItsWeightsAsTheGelMoves) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  const Vec2 point = s.cell.cortex.x[0] + Vec2(8.0, 0.3);
  const PointWeights fresh = hold_weights(point, s.ecm, p);
  add_protrusion(s, 0, Contracting{.anchor = point, .f_mat = 0.8, .held = reference_position(point, fresh, s.ecm)});
  EXPECT_LT((reference_position(point, fresh, s.ecm) - point).norm(), 1e-12) << "nothing has moved yet";
  for (std::size_t i = 0; i < s.ecm.size(); ++i) s.ecm.x[i] += Vec2(3.0 + 0.4 * s.ecm.X[i].y(), 1.0);
  const PointWeights by_matter = hold_weights(s.cell.protrusions[0].phase, s.ecm, p);
  EXPECT_EQ(by_matter.index, fresh.index);
  EXPECT_EQ(by_matter.weight, fresh.weight);
  EXPECT_NE(hold_weights(point, s.ecm, p).index, fresh.index) << "those that are there now";
}

TEST(Hold, ReferencePositionUndoesALinearDisplacement) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  const Vec2 X = s.cell.cortex.x[0] + Vec2(9.0, 0.2);
  for (std::size_t i = 0; i < s.ecm.size(); ++i) s.ecm.x[i] = s.ecm.X[i] + Vec2(2.0, -1.0);
  const Vec2 x = X + Vec2(2.0, -1.0);
  EXPECT_LT((reference_position(x, hold_weights(x, s.ecm, p), s.ecm) - X).norm(), 1e-12);
}

TEST(Hold, SpreadsOverAWiderKernelWhereAsked) {
  Parameters p = small_matrix();
  const Scene s = cell_in_matrix(p);
  const Vec2 point = s.cell.cortex.x[0] + Vec2(12.0, 0.3);
  const std::size_t narrow = hold_weights(point, s.ecm, p).index.size();
  p.adhesion.spread = 2.0;
  const PointWeights wide = hold_weights(point, s.ecm, p);
  EXPECT_GT(wide.index.size(), 3 * narrow);
  for (const std::uint32_t i : wide.index) EXPECT_LT((s.ecm.x[i] - point).norm(), 4.0 * p.ecm.smoothing_length);
}
