#include "cell/geometry.hpp"
#include "protrusion/deflection.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/initiation.hpp"
#include "protrusion/membership.hpp"
#include "protrusion/polarization.hpp"
#include "scene.hpp"
#include "sph/kernel.hpp"
#include "statistics/distributions.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numbers>
#include <set>

using namespace matrigrate;

namespace {

const Vec2 tip(20.0, 0.0);
const Vec2 ahead(1.0, 0.0);
bool nowhere(const Vec2&) { return false; }

/// Intact matrix, but for where `degraded` says.
EcmState matrix(const Parameters& p, const std::function<bool(const Vec2&)>& degraded) {
  EcmState ecm = disc(p);
  for (std::size_t k = 0; k < ecm.size(); ++k) ecm.f[k] = degraded(ecm.x[k]) ? 0.0 : 1.0;
  return ecm;
}

} // namespace

TEST(Deflection, IsNoneInIntactOrSymmetricallyDegradedMatrix) {
  const Parameters p = small_matrix();
  EXPECT_EQ(deflection_speed(matrix(p, nowhere), p, tip, ahead, ahead, nowhere), 0.0);
  const EcmState strip = matrix(p, [](const Vec2& x) { return std::abs(x.y()) < 3.5; });
  EXPECT_NEAR(deflection_speed(strip, p, tip, ahead, ahead, nowhere), 0.0, 1e-12);
  const EcmState all = matrix(p, [](const Vec2&) { return true; });
  EXPECT_NEAR(deflection_speed(all, p, tip, ahead, ahead, nowhere), 0.0, 1e-12);
}

TEST(Deflection, TurnsTowardsDegradedMatrixAndMirrors) {
  const Parameters p = small_matrix();
  const double left =
      deflection_speed(matrix(p, [](const Vec2& x) { return x.y() > 0.5; }), p, tip, ahead, ahead, nowhere);
  const double right =
      deflection_speed(matrix(p, [](const Vec2& x) { return x.y() < -0.5; }), p, tip, ahead, ahead, nowhere);
  EXPECT_GT(left, 0.0);
  EXPECT_DOUBLE_EQ(left, -right);
  EXPECT_LT(left, p.protrusion.deflection_rate * std::sin(p.protrusion.deflection_cone)); // no faster than all there
}

TEST(Deflection, OfASingleFluidParticleIsItsWeightTimesTheSine) {
  Parameters p = small_matrix();
  const Vec2 there(24.0, 2.0);
  const EcmState ecm = matrix(p, [&](const Vec2& x) { return (x - there).norm() < 0.1; });
  const Kernel kernel(p.ecm.smoothing_length);
  double weights = 0.0;
  for (const Vec2& x : ecm.x) {
    const Vec2 r = x - tip;
    if (r.norm() > 2.4 && r.norm() < 5.2 && r.x() >= 0.5 * r.norm() - 1e-12) weights += kernel.W(r.norm());
  }
  const Vec2 r = there - tip;
  const double expected = 0.1 * kernel.W(r.norm()) * (r.y() / r.norm()) / weights;
  ASSERT_GT(expected, 0.0);
  EXPECT_NEAR(deflection_speed(ecm, p, tip, ahead, ahead, nowhere), expected, 1e-9);
}

TEST(Deflection, LooksNeitherAtTheTunnelBehindNorAtItsOwnWork) {
  const Parameters p = small_matrix();
  const EcmState behind = matrix(p, [](const Vec2& x) { return x.x() < 20.5 && x.y() > -0.5; });
  EXPECT_EQ(deflection_speed(behind, p, tip, ahead, ahead, nowhere), 0.0);
  const EcmState near = matrix(p, [](const Vec2& x) { return (x - tip).norm() < 2.4 && x.y() > 0.0; });
  EXPECT_EQ(deflection_speed(near, p, tip, ahead, ahead, nowhere), 0.0);
}

TEST(Deflection, TurnsNoFurtherThanTheConeAheadOfTheTip) { // and not on and on into a gap beside the cell
  const Parameters p = small_matrix();
  const EcmState ecm = matrix(p, [](const Vec2& x) { return x.y() > 0.5; });
  Vec2 d = ahead;
  for (int k = 0; k < 2000; ++k) d = Eigen::Rotation2Dd(0.4 * deflection_speed(ecm, p, tip, d, ahead, nowhere)) * d;
  EXPECT_LT(std::acos(d.dot(ahead)), p.protrusion.deflection_cone);
  EXPECT_GT(d.y(), 0.3);
}

TEST(Deflection, DoesNotTurnIntoTheCellItself) {
  const Parameters p = small_matrix();
  const EcmState ecm = matrix(p, [](const Vec2& x) { return x.y() > 0.5; });
  const double speed = deflection_speed(ecm, p, tip, ahead, ahead, [](const Vec2& x) { return x.y() > 0.5; });
  EXPECT_EQ(speed, 0.0);
}

TEST(Deflect, TurnsTheDirectionOfGrowingProtrusionsAndKeepsItAUnitVector) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  s.ecm = matrix(p, [](const Vec2& x) { return x.y() > 0.5; });
  add_protrusion(s, 0, Growing{ahead});
  add_protrusion(s, 117, Maturing{-ahead, Vec2(-20.0, 0.0), 0});
  const std::vector<Vec2> n = normals(s.cell.cortex);
  for (int k = 0; k < 20; ++k) deflect(s.cell, s.ecm, p, 0.4, n, nowhere);
  const Vec2 d = std::get<Growing>(s.cell.protrusions[0].phase).direction;
  EXPECT_NEAR(d.norm(), 1.0, 1e-12);
  EXPECT_GT(d.y(), 0.05);
  EXPECT_EQ(std::get<Maturing>(s.cell.protrusions[1].phase).direction, Vec2(-ahead));
}

TEST(PushingParticles, AreTheCentreAndThreeToEachSide) {
  const Parameters p = small_matrix();
  const Scene s = cell_in_matrix(p);
  const std::vector<std::size_t> pushing = pushing_particles(s.cell.cortex, 1, p.protrusion);
  EXPECT_EQ((std::set<std::size_t>(pushing.begin(), pushing.end())), (std::set<std::size_t>{233, 234, 0, 1, 2, 3, 4}));
}

TEST(GrowthForce, IsAShareOfFProtAlongItsDirectionAndFadesAsTheNormalTurns) {
  const ProtrusionParameters p;
  const Vec2 d = Vec2(3.0, 4.0) / 5.0;
  EXPECT_LT((growth_force(d, d, p) - 0.32 / 7.0 * d).norm(), 1e-15);
  const Vec2 turned = Eigen::Rotation2Dd(1.0471975511965976) * d; // 60 degrees
  EXPECT_LT((growth_force(d, turned, p) - 0.16 / 7.0 * d).norm(), 1e-15);
  EXPECT_EQ(growth_force(d, perpendicular(d), p).norm(), 0.0);
  EXPECT_EQ(growth_force(d, -d, p).norm(), 0.0);
}

TEST(AreaFactor, IsTheInverseAreaWhereANumberIsEnforced) {
  Parameters p;
  const auto factor = [&](double area) { return Law("laws.growth_force", p)({area, 10.0, 200.0, 0.05}); };
  EXPECT_EQ(factor(1.7), 1.0); // Eq. (10) is for a kept number alone
  p.protrusion.number = 2;
  EXPECT_EQ(factor(0.9), 1.0);
  EXPECT_EQ(factor(1.0), 1.0);
  EXPECT_DOUBLE_EQ(factor(1.46), 1.0 / 1.46);
  EXPECT_DOUBLE_EQ(factor(2.0), 0.5);
  EXPECT_DOUBLE_EQ(factor(2.5), 0.4);
}

TEST(Growth, PushesOnlyTheTipsOfGrowingProtrusions) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 30, Growing{outward(s, 30)});
  add_protrusion(s, 120, Contracting{2.0 * s.cell.cortex.x[120], 0.5});
  const std::vector<Vec2> force = assemble(s.nodes(), [&](std::span<Vec2> F, DragSystem& A) {
                                    add_growth(s.cell, p.protrusion, 1.0, normals(s.cell.cortex), s.first(), F, A, 0.0,
                                               Law("laws.growth_force", p));
                                  }).force;
  const Vec2 sum = net_force(force);
  EXPECT_GT(sum.dot(outward(s, 30)), 0.99 * 0.32); // the tip is nearly flat
  EXPECT_LE(sum.norm(), 0.32);
  EXPECT_LT(std::abs(cross(sum, outward(s, 30))), 1e-12);
  for (std::size_t i = 0; i < force.size(); ++i) {
    const bool at_tip = i >= s.node(27) && i <= s.node(33);
    EXPECT_EQ(force[i].norm() > 0.0, at_tip) << i;
  }
}

TEST(Spreading, EvensOutEachFlankAlongItsContourAndKeepsTipAndBase) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 100, Growing{outward(s, 100)});
  for (std::size_t i = 95; i <= 105; ++i) s.cell.cortex.x[i] *= 1.6; // a spike: all stretch in two segments
  const CortexState before = s.cell.cortex;
  for (int k = 0; k < 400; ++k) spread_evenly(s.cell, p.protrusion, 0.4);
  for (const std::size_t kept : {80, 100, 120}) EXPECT_EQ(s.cell.cortex.x[kept], before.x[kept]);
  for (std::size_t i = 0; i < 80; ++i) EXPECT_EQ(s.cell.cortex.x[i], before.x[i]);
  EXPECT_EQ(s.cell.cortex.l0, before.l0);
  double longest = 0.0, shortest = 1e9;
  for (std::size_t i = 80; i < 100; ++i) {
    const double l = (s.cell.cortex.x[i + 1] - s.cell.cortex.x[i]).norm();
    longest = std::max(longest, l);
    shortest = std::min(shortest, l);
  }
  EXPECT_LT(longest, 1.02 * shortest);
  EXPECT_NEAR(area(s.cell.cortex), area(before), 0.03 * area(before));
}

TEST(Spreading, GoesAsFarInOneLongStepAsInManyShortOnes) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 100, Growing{outward(s, 100)});
  for (const int side : {-1, 1}) // straight flanks, spaced more and more widely
    for (int k = 0; k <= 20; ++k) {
      const double share = k * (k + 1) / 420.0;
      const Vec2 middle = s.cell.cortex.x[100], base = s.cell.cortex.x[s.cell.cortex.along(100, 20 * side)];
      if (k > 0 && k < 20) s.cell.cortex.x[s.cell.cortex.along(100, k * side)] = (1.0 - share) * middle + share * base;
    }
  Scene once = s;
  spread_evenly(once.cell, p.protrusion, 2.4);
  for (int k = 0; k < 6; ++k) spread_evenly(s.cell, p.protrusion, 0.4);
  for (std::size_t i = 0; i < s.cell.cortex.size(); ++i)
    EXPECT_LT((once.cell.cortex.x[i] - s.cell.cortex.x[i]).norm(), 1e-9) << i;
}

TEST(Spreading, LeavesOtherPhasesAlone) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  s.cell.cortex = wavy_cortex(p.cell);
  add_protrusion(s, 100, Finishing{0.5});
  const CortexState before = s.cell.cortex;
  spread_evenly(s.cell, p.protrusion, 0.4);
  EXPECT_EQ(s.cell.cortex.x, before.x);
}

TEST(BaseTie, PullsTheEndsOfAWidenedBaseTogetherAndNothingElse) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  const double width = base_width(s.cell.cortex, 100, p.protrusion);
  EXPECT_NEAR(width, (s.cell.cortex.x[120] - s.cell.cortex.x[80]).norm(), 1e-15);
  add_protrusion(s, 100, Growing{outward(s, 100), width});
  const auto tied = [&] {
    return assemble(s.nodes(), [&](std::span<Vec2> force, DragSystem& A) {
      add_base_ties(s.cell, p.protrusion, p.cell.spring_stiffness, 0.4, s.first(), force, A);
    });
  };
  const Vec2 along = (s.cell.cortex.x[120] - s.cell.cortex.x[80]) / width;
  s.cell.cortex.x[120] += 2.0 * along;
  const Assembled a = tied();
  const double T = 2.8 / 40.0 * 2.0; // k_s over the 40 segments
  EXPECT_LT((a.force[s.node(80)] - T * along).norm(), 1e-12);
  EXPECT_LT((a.force[s.node(120)] + T * along).norm(), 1e-12);
  EXPECT_LT(net_force(a.force).norm(), 1e-15);
  EXPECT_EQ(a.A.directed.size(), 2U);
  EXPECT_DOUBLE_EQ(a.A.directed.c[0], 0.4 * 2.8 / 40.0);
  EXPECT_NEAR(a.A.directed.c[1], 0.4 * T / (width + 2.0), 1e-12) << "across";
  s.cell.cortex.x[120] -= 3.0 * along;
  EXPECT_EQ(largest(tied().force), 0.0) << "tension only";
}

TEST(ProtrusionLength, RunsFromTheMiddleOfTheBaseToTheCentre) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  const Vec2 base = 0.5 * (s.cell.cortex.x[80] + s.cell.cortex.x[120]);
  s.cell.cortex.x[100] = base + Vec2(-12.0, 16.0);
  EXPECT_NEAR(protrusion_length(s.cell.cortex, 100, p.protrusion), 20.0, 1e-12);
}

TEST(RelaxedRestLengths, AreTheLengthsOfTheProtrusionAlone) {
  const Parameters p = small_matrix();
  CortexState c = wavy_cortex(p.cell);
  const CortexState before = c;
  relax_rest_lengths(c, 10, p.protrusion);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const bool inside = i < 30 || i >= 225; // 10 - 20 wraps to 225
    EXPECT_DOUBLE_EQ(c.l0[i], inside ? (c.x[c.next(i)] - c.x[i]).norm() : before.l0[i]) << i;
  }
}

TEST(Membership, OfACellWithoutProtrusionsIsAllBody) {
  const Parameters p = small_matrix();
  const Membership m = membership(round_cell(p), p);
  EXPECT_TRUE(std::ranges::all_of(m.of_particle, [](int n) { return n == no_protrusion; }));
  EXPECT_TRUE(std::ranges::all_of(m.f_mat, [](double f) { return f == 0.05; }));
  EXPECT_TRUE(std::ranges::all_of(m.k_s, [](double k) { return k == 2.8; }));
  EXPECT_EQ(std::ranges::count(m.on_protrusion, 1), 0);
  EXPECT_EQ(std::ranges::count(m.soft, 1), 0);
}

TEST(Membership, SpansTwentyParticlesToEachSideAcrossTheSeam) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 5, Growing{outward(s, 5)});
  const Membership m = membership(s.cell, p);
  EXPECT_EQ(std::ranges::count(m.of_particle, 0), 41);
  EXPECT_EQ(m.of_particle[25], 0);
  EXPECT_EQ(m.of_particle[26], no_protrusion);
  EXPECT_EQ(m.of_particle[220], 0); // 235 - 15
  EXPECT_EQ(m.of_particle[219], no_protrusion);
  EXPECT_EQ(std::ranges::count(m.on_protrusion, 1), 40);
  EXPECT_EQ(m.on_protrusion[25], 0); // its second end is body
}

TEST(Membership, SaysWhatEachPhaseMakesOfTheCortex) {
  const Parameters p = small_matrix();
  struct Row {
    Phase phase;
    double f_mat, k_s;
    int soft;
  };
  const Vec2 d(1.0, 0.0);
  for (const Row& row : {Row{Growing{d}, 0.0, 2.8e-3, 1}, Row{Maturing{d, d, 3}, 0.0, 2.8e-3, 1},
                         Row{Contracting{d, 0.7}, 0.7, 2.8, 0}, Row{Finishing{0.6}, 0.6, 2.8, 0}}) {
    Scene s = cell_in_matrix(p);
    add_protrusion(s, 100, row.phase);
    const Membership m = membership(s.cell, p);
    for (std::size_t i = 80; i <= 120; ++i) EXPECT_EQ(m.f_mat[i], row.f_mat) << name(row.phase);
    for (std::size_t i = 80; i < 120; ++i) {
      EXPECT_EQ(m.k_s[i], row.k_s) << name(row.phase);
      EXPECT_EQ(m.soft[i], row.soft) << name(row.phase);
    }
    EXPECT_EQ(m.f_mat[79], 0.05);
    EXPECT_EQ(m.k_s[120], 2.8);
  }
}

namespace {

constexpr double pi = std::numbers::pi;

/// r_pol, 1.1e-3 /s.
const Law& rate() {
  static const Law law("laws.polarization_rate", {});
  return law;
}

} // namespace

TEST(AdhesionDirection, IsTheMeanOfTheUnitVectorsToMatureAdhesions) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  const Vec2 centre(1.0, -1.0);
  EXPECT_FALSE(adhesion_direction(s.cell, centre));
  add_protrusion(s, 0, Contracting{centre + Vec2(40.0, 0.0), 0.5});
  EXPECT_DOUBLE_EQ(*adhesion_direction(s.cell, centre), 0.0);
  add_protrusion(s, 60, Contracting{centre + Vec2(0.0, 3.0), 0.5}); // the distance does not count
  EXPECT_DOUBLE_EQ(*adhesion_direction(s.cell, centre), 0.25 * pi);
  add_protrusion(s, 120, Maturing{Vec2(-1.0, 0.0), centre + Vec2(-30.0, 0.0), 0}); // immature ones do not
  EXPECT_DOUBLE_EQ(*adhesion_direction(s.cell, centre), 0.25 * pi);
}

TEST(AdhesionDirection, IsNoneBetweenOppositeAdhesions) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 0, Contracting{Vec2(20.0, 0.0), 0.5});
  add_protrusion(s, 117, Contracting{Vec2(-35.0, 0.0), 0.5});
  EXPECT_FALSE(adhesion_direction(s.cell, Vec2::Zero()));
}

TEST(Turned, ApproachesTheTargetExponentiallyAtRPol) {
  double angle = 0.2;
  for (int k = 0; k < 2500; ++k) angle = turned(angle, 1.2, 0.4, rate()); // 1000 s
  EXPECT_NEAR(1.2 - angle, std::exp(-1.1), 1e-9);
  EXPECT_NEAR(turned(0.2, 1.2, 1000.0, rate()), angle, 1e-9); // whatever the step
}

TEST(Turned, TakesTheShorterWayRound) {
  EXPECT_GT(turned(3.0, -3.0, 0.4, rate()), 3.0);
  EXPECT_LT(turned(-3.0, 3.0, 0.4, rate()), -3.0);
  EXPECT_LE(std::abs(turned(3.1, -2.0, 1000.0, rate())), pi);
}

TEST(Polarize, WaitsForTheFirstProtrusionAndForAdhesions) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 0, Contracting{Vec2(0.0, 20.0), 0.5});
  polarize(s.cell, Vec2::Zero(), 0.4, rate());
  EXPECT_FALSE(s.cell.polarization);
  s.cell.polarization = 0.0;
  polarize(s.cell, Vec2::Zero(), 0.4, rate());
  EXPECT_NEAR(*s.cell.polarization, -std::expm1(-1.1e-3 * 0.4) * 0.5 * pi, 1e-12);
  s.cell.protrusions.clear();
  const double kept = *s.cell.polarization;
  polarize(s.cell, Vec2::Zero(), 0.4, rate());
  EXPECT_EQ(*s.cell.polarization, kept);
}

// A hundred particles of propensity 3 and fifty of propensity 1 have the rate of 350; the others, of none, stay quiet.
TEST(Propensity, IsAFactorOnTheRateOfAParticle) {
  Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  const std::vector<std::uint8_t> all(s.cell.cortex.size(), 1);
  const std::vector<Vec2> n = normals(s.cell.cortex);
  const std::vector<double> rate(all.size(), p.protrusion.initiation_rate);
  std::vector<double> propensity(all.size(), 0.0);
  std::fill_n(propensity.begin(), 100, 3.0);
  std::fill_n(propensity.begin() + 100, 50, 1.0);
  std::vector<double> times;
  double of_first = 0.0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    p.run.seed = seed;
    Scene at = s;
    while (at.cell.protrusions.empty()) {
      next_step(at, p);
      initiate(at.cell, at.now, p, p.run.time_step,
               {.of_front = all, .normals = n, .rate = rate, .propensity = propensity});
    }
    const std::uint32_t centre = at.cell.protrusions[0].centre;
    ASSERT_LT(centre, 150U);
    of_first += centre < 100 ? 1e-3 : 0.0;
    times.push_back(at.now.t - 0.5 * p.run.time_step);
  }
  EXPECT_LT(kolmogorov_smirnov_exponential(times, 350 * 6e-5), one_in_a_hundred);
  EXPECT_NEAR(of_first, 300.0 / 350.0, 4.0 * std::sqrt(300.0 * 50.0) / 350.0 / std::sqrt(1000.0));
}

TEST(Propensity, OfOneChangesNothing) {
  Parameters p = small_matrix();
  p.protrusion.initiation_rate = 1e-3;
  const Scene start = cell_in_matrix(p);
  const std::vector<std::uint8_t> of_front = front(start.cell.cortex, 0.3);
  const std::vector<Vec2> n = normals(start.cell.cortex);
  const std::vector<double> rate(of_front.size(), p.protrusion.initiation_rate);
  const std::vector<double> one(of_front.size(), 1.0);
  for (const int number : {0, 2}) {
    p.protrusion.number = number;
    Scene plain = start;
    Scene s = start;
    for (int k = 0; k < 400; ++k) {
      next_step(plain, p);
      initiate(plain.cell, plain.now, p, p.run.time_step, {.of_front = of_front, .normals = n, .rate = rate});
      initiate(s.cell, plain.now, p, p.run.time_step,
               {.of_front = of_front, .normals = n, .rate = rate, .propensity = one});
    }
    ASSERT_FALSE(s.cell.protrusions.empty());
    ASSERT_EQ(s.cell.protrusions.size(), plain.cell.protrusions.size());
    for (std::size_t k = 0; k < s.cell.protrusions.size(); ++k) {
      EXPECT_EQ(s.cell.protrusions[k].centre, plain.cell.protrusions[k].centre);
      EXPECT_EQ(s.cell.protrusions[k].since, plain.cell.protrusions[k].since);
    }
  }
}

// A rate of 0 for all is that of the paper's kept numbers with initiation_rate = 0.
TEST(Rate, ThatIsTheSameForAllTellsNoCandidateFromAnother) {
  Parameters p = small_matrix();
  p.protrusion.number = 1;
  const Scene start = cell_in_matrix(p);
  const std::vector<std::uint8_t> all(start.cell.cortex.size(), 1);
  const std::vector<Vec2> n = normals(start.cell.cortex);
  std::vector<std::uint32_t> centres;
  for (const double r : {0.0, 1e-3, 7.0}) {
    const std::vector<double> rate(all.size(), r);
    Scene s = start;
    while (s.cell.protrusions.empty()) {
      next_step(s, p);
      initiate(s.cell, s.now, p, p.run.time_step, {.of_front = all, .normals = n, .rate = rate});
    }
    centres.push_back(s.cell.protrusions[0].centre);
  }
  EXPECT_EQ(centres, std::vector<std::uint32_t>(3, centres[0]));
}

TEST(Propensity, OfZeroLeavesNoCandidate) {
  Parameters p = small_matrix();
  p.protrusion.number = 1;
  Scene s = cell_in_matrix(p);
  const std::vector<std::uint8_t> all(s.cell.cortex.size(), 1);
  const std::vector<Vec2> n = normals(s.cell.cortex);
  const std::vector<double> rate(all.size(), p.protrusion.initiation_rate);
  const std::vector<double> none(all.size(), 0.0);
  for (int k = 0; k < 100; ++k) {
    next_step(s, p);
    initiate(s.cell, s.now, p, p.run.time_step, {.of_front = all, .normals = n, .rate = rate, .propensity = none});
  }
  EXPECT_TRUE(s.cell.protrusions.empty());
}

TEST(Propensity, DecidesAmongTheCandidatesOfAKeptNumber) {
  Parameters p = small_matrix();
  p.protrusion.number = 1;
  Scene s = cell_in_matrix(p);
  const std::vector<std::uint8_t> all(s.cell.cortex.size(), 1);
  const std::vector<Vec2> n = normals(s.cell.cortex);
  const std::vector<double> rate(all.size(), p.protrusion.initiation_rate);
  std::vector<double> propensity(all.size(), 0.0);
  propensity[40] = 2.0;
  propensity[70] = 6.0;
  int of_second = 0;
  constexpr int cells = 2000;
  for (int k = 0; k < cells; ++k) {
    s.cell.protrusions.clear();
    next_step(s, p);
    initiate(s.cell, s.now, p, p.run.time_step,
             {.of_front = all, .normals = n, .rate = rate, .propensity = propensity});
    ASSERT_EQ(s.cell.protrusions.size(), 1U);
    ASSERT_TRUE(s.cell.protrusions[0].centre == 40 || s.cell.protrusions[0].centre == 70);
    of_second += s.cell.protrusions[0].centre == 70 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(of_second) / cells, 0.75, 4.0 * std::sqrt(0.75 * 0.25 / cells));
}
