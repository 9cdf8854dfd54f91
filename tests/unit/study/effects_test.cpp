#include "study/effects.hpp"

#include "study/design/designs.hpp"
#include "unit/study/studies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace matrigrate::study {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Results in which f_mat is a function of the parameters of the point, the same for all replicates.
std::vector<Result> computed(const Study& s, const std::function<double(const Parameters&)>& f) {
  std::vector<std::vector<double>> samples;
  for (const Point& point : s.points) samples.emplace_back(s.replicates, f(point.parameters));
  return results_of("f_mat", samples);
}

const Effect& of(const std::vector<Effect>& all, const std::string& factor, const std::string& readout = "f_mat") {
  for (const Effect& e : all)
    if (e.factor == factor && e.readout == readout) return e;
  static const Effect none;
  ADD_FAILURE() << "no effect of " << factor;
  return none;
}

const std::string morris = "readouts = [\"f_mat\"]\n[morris]\ntrajectories = 20\necm.youngs_modulus = [100, 300]\n"
                           "adhesion.rupture = [false, true]\nprotrusion.number = [1, 3]\n"
                           "ecm.viscosity = [\"10 Pa s\", \"1000 Pa s\", \"log\"]\n";

TEST(Effects, OfALinearFunctionAreExact) {
  const Study s = read(morris);
  const auto all =
      effects(s, computed(s, [](const Parameters& p) {
                return 10.0 * p.ecm.youngs_modulus - 0.5 * p.protrusion.number + (p.adhesion.rupture ? 3.0 : 0.0);
              }));
  ASSERT_EQ(all.size(), 4U);
  const auto expect = [&](const std::string& factor, double mu, std::size_t rank) {
    const Effect& e = of(all, factor);
    EXPECT_EQ(e.n, 20U);
    EXPECT_NEAR(e.elementary.mu.value, mu, 1e-9) << factor;
    EXPECT_NEAR(e.elementary.mu_star.value, std::abs(mu), 1e-9) << factor;
    EXPECT_NEAR(e.elementary.sigma.value, 0.0, 1e-9) << factor;
    EXPECT_NEAR(e.elementary.mu_star.high, std::abs(mu), 1e-9) << factor;
    EXPECT_EQ(e.rank, rank) << factor;
  };
  expect("adhesion.rupture", 3.0, 1);
  expect("ecm.youngs_modulus", 2.0, 2); // 10 x 0.2 kPa
  expect("protrusion.number", -1.0, 3); // -0.5 x 2, whatever the rounding of its levels
  expect("ecm.viscosity", 0.0, 4);
}

TEST(Effects, OnALogarithmicScaleAreOfTheLogarithm) {
  const Study s = read(morris);
  const auto all = effects(s, computed(s, [](const Parameters& p) { return std::log10(p.ecm.viscosity); }));
  EXPECT_NEAR(of(all, "ecm.viscosity").elementary.mu.value, 2.0, 1e-9);
  EXPECT_NEAR(of(all, "ecm.viscosity").elementary.sigma.value, 0.0, 1e-9);
}

TEST(Effects, OfAProductDependOnTheOtherFactor) {
  // y = u v with both on four levels: the effect of u is v, of which the levels are 0, 1/3, 2/3, 1, evenly drawn.
  const Study s = read("readouts = [\"f_mat\"]\n[morris]\ntrajectories = 400\necm.youngs_modulus = [100, 400]\n"
                       "ecm.viscosity = [100, 400]\n");
  const auto all = effects(s, computed(s, [](const Parameters& p) {
                             return (p.ecm.youngs_modulus - 0.1) / 0.3 * (p.ecm.viscosity - 0.1) / 0.3;
                           }));
  for (const char* factor : {"ecm.youngs_modulus", "ecm.viscosity"}) {
    const Effect& e = of(all, factor);
    const double sd = std::sqrt(5.0 / 36.0); // of the four levels
    EXPECT_NEAR(e.elementary.mu_star.value, 0.5, 4.0 * sd / 20.0) << factor;
    EXPECT_NEAR(e.elementary.sigma.value, sd, 0.05) << factor;
    EXPECT_LT(e.elementary.mu_star.low, 0.5);
    EXPECT_GT(e.elementary.mu_star.high, 0.5);
    EXPECT_NEAR(e.elementary.mu_star.high - e.elementary.mu_star.low, 2.0 * 1.96 * sd / 20.0, 0.02);
  }
}

TEST(Effects, RankTheFactorsOfSobolsG) {
  // g = product of (|4 u - 2| + a) / (1 + a): the smaller a, the more a factor matters.
  const Study s = read("readouts = [\"f_mat\"]\n[morris]\ntrajectories = 100\necm.youngs_modulus = [100, 400]\n"
                       "ecm.viscosity = [100, 400]\necm.radius = [100, 400]\nactomyosin.force = [1, 4]\n");
  const auto g = [](double u, double a) { return (std::abs(4.0 * u - 2.0) + a) / (1.0 + a); };
  const auto all = effects(s, computed(s, [&](const Parameters& p) {
                             return g((p.ecm.youngs_modulus - 0.1) / 0.3, 9.0) * g((p.ecm.viscosity - 0.1) / 0.3, 0.01)
                                    * g((p.ecm.radius - 100.0) / 300.0, 99.0)
                                    * g((p.actomyosin.force - 1.0) / 3.0, 1.0);
                           }));
  std::vector<std::string> order;
  for (const Effect& e : all) order.push_back(e.factor);
  EXPECT_EQ(order, (std::vector<std::string>{"ecm.viscosity", "actomyosin.force", "ecm.youngs_modulus", "ecm.radius"}));
  EXPECT_GT(all[0].elementary.mu_star.value, 2.0 * std::abs(all[0].elementary.mu.value))
      << "it is not monotonic: effects of both signs cancel in mu, not in mu*";
}

const std::string one = "readouts = [\"f_mat\"]\n[one_at_a_time]\nadhesion.rupture = [true]\nprotrusion.number = [1]\n";

TEST(Effects, OneAtATimeArePairedByReplicate) {
  const Study s = read(one);
  const auto results = results_of("f_mat", {{1.0, 5.0, 9.0}, {1.5, 5.6, 9.4}, {3.0, nan, 5.0}});
  const auto all = effects(s, results);
  ASSERT_EQ(all.size(), 2U);
  const Effect& e = of(all, "adhesion.rupture");
  EXPECT_TRUE(e.paired);
  EXPECT_EQ(e.value, "true");
  EXPECT_EQ(e.n, 3U);
  EXPECT_NEAR(e.effect.value, 0.5, 1e-12);
  EXPECT_NEAR(e.effect.high, 0.5 + 4.302652729911275 * 0.1 / std::sqrt(3.0), 1e-9) << "t of 2 degrees of freedom";
  const Effect& number = of(all, "protrusion.number");
  EXPECT_EQ(number.n, 2U) << "replicates that have a value at both";
  EXPECT_NEAR(number.effect.value, -1.0, 1e-12);
  EXPECT_EQ(number.rank, 1U) << "by size";

  const Study apart = read("common_random_numbers = false\n" + one);
  const Effect welch = of(effects(apart, results), "adhesion.rupture");
  EXPECT_FALSE(welch.paired);
  EXPECT_NEAR(welch.effect.value, 0.5, 1e-12);
  EXPECT_GT(welch.effect.high - welch.effect.low, 10.0) << "the scatter of runs is not taken away";
}

TEST(Effects, OnTheDiscrepancyAreDifferencesOfIt) {
  const std::string target = "[[targets]]\nreadout = \"f_mat\"\nvalue = 1\nerror = 0.5\n";
  const Study s = read(one + target);
  const auto all = effects(s, results_of("f_mat", {{3.0, 3.0, 3.0}, {2.0, 2.0, 2.0}, {nan, nan, 2.0}}));
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].readout, "discrepancy");
  EXPECT_EQ(all[0].factor, "adhesion.rupture");
  EXPECT_NEAR(all[0].effect.value, 2.0 - 4.0, 1e-12);
  EXPECT_NEAR(all[0].effect.low, -2.0, 1e-12);
  EXPECT_EQ(all[0].n, 1U) << "targets";
  EXPECT_TRUE(std::isnan(all[1].effect.value)) << "its target could not be judged";
  EXPECT_EQ(all[1].rank, 0U);
  // Replicates that go up and down together leave no uncertainty in the difference if they are paired.
  const std::vector<double> base{3.0, 4.0, 5.0};
  const auto width = [&](const Study& study) {
    const Effect e = of(effects(study, results_of("f_mat", {base, base, base})), "adhesion.rupture", "discrepancy");
    return e.effect.high - e.effect.low;
  };
  EXPECT_EQ(width(s), 0.0);
  EXPECT_GT(width(read("common_random_numbers = false\n" + one + target)), 0.5);
}

TEST(Effects, OfEachCondition) {
  const Study s = read(one + "[[conditions]]\nlabel = \"a\"\n[[conditions]]\nlabel = \"b\"\necm.viscosity = 500\n");
  const auto all = effects(s, results_of("f_mat", {{1, 1}, {2, 2}, {4, 4}, {2, 2}, {1, 1}, {7, 7}}));
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].condition, 0U);
  EXPECT_EQ(all[0].factor, "adhesion.rupture");
  EXPECT_EQ(all[0].effect.value, 3.0);
  EXPECT_EQ(all[2].condition, 1U);
  EXPECT_EQ(all[2].factor, "protrusion.number");
  EXPECT_EQ(all[2].effect.value, 5.0);
  const std::string csv = effects_csv(s, all);
  EXPECT_NE(csv.find("\none_at_a_time,f_mat,b,1,protrusion.number,1,true,2,5,5,5,,,,,,,,,\n"), std::string::npos)
      << csv;
}

TEST(Effects, OfMorrisOnTheDiscrepancyAndInATable) {
  const Study s = read(morris + "[[targets]]\nreadout = \"f_mat\"\nvalue = 0\nerror = 1\n");
  const auto all = effects(s, computed(s, [](const Parameters& p) { return 10.0 + 10.0 * p.ecm.youngs_modulus; }));
  const Effect& e = of(all, "ecm.youngs_modulus", "discrepancy");
  EXPECT_NEAR(e.elementary.mu.value, 2.0, 1e-9) << "above the target, the discrepancy grows as the read-out does";
  EXPECT_EQ(e.rank, 1U);
  const std::string csv = effects_csv(s, all);
  EXPECT_NE(csv.find("\nmorris,f_mat,,1,ecm.youngs_modulus,,true,20,,,,2,2,2,2,2,2,"), std::string::npos) << csv;
  EXPECT_TRUE(effects(read("[sweep]\nprotrusion.number = [1, 2]\n"), {}).empty());
}

} // namespace
} // namespace matrigrate::study
