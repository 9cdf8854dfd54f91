#include "study_results/discrepancy.hpp"

#include "statistics/bootstrap.hpp"
#include "unit/study_plan/studies.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace matrigrate::study {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

const std::string target = "[[targets]]\nreadout = \"f_mat\"\nvalue = 0.5\nerror = 0.1\n";
const std::string two_values = "readouts = [\"f_mat\"]\n[sweep]\nprotrusion.number = [1, 2]\n";

TEST(Distance, IsInStandardErrorsOfBoth) {
  const Target value{.readout = "f_mat", .low = 10.0, .high = 10.0, .error = 3.0, .weight = 1.0, .at = {}};
  const std::vector<double> x{9.0, 13.0, 17.0, 21.0}; // mean 15, variance 80/3, standard error sqrt(20/3)
  EXPECT_DOUBLE_EQ(distance(value, x), 5.0 / std::sqrt(9.0 + 20.0 / 3.0));
  EXPECT_TRUE(std::isnan(distance(value, std::vector<double>{9.0})));
  Target range = value;
  range.high = 14.0;
  EXPECT_DOUBLE_EQ(distance(range, x), 1.0 / std::sqrt(9.0 + 20.0 / 3.0)) << "from the nearer end";
  range.high = 15.0;
  EXPECT_EQ(distance(range, x), 0.0) << "inside";
  range.low = range.high = 18.0;
  EXPECT_DOUBLE_EQ(distance(range, x), -3.0 / std::sqrt(9.0 + 20.0 / 3.0)) << "with its sign";
}

TEST(Discrepancy, IsTheWeightedRootMeanSquareOfTargets) {
  const Study s = read("readouts = [\"f_mat\"]\n[[conditions]]\nlabel = \"a\"\n[[conditions]]\nlabel = \"b\"\n"
                       "ecm.viscosity = 500\n[[targets]]\nreadout = \"f_mat\"\nvalue = 0.5\nerror = 0.1\nat = \"a\"\n"
                       "[[targets]]\nreadout = \"f_mat\"\nvalue = 0.5\nerror = 0.1\nweight = 3\nat = \"b\"\n");
  const Discrepancy d = TargetJudge(s, results_of("f_mat", {{0.7, 0.7}, {0.4, 0.4}})).discrepancy(0);
  EXPECT_NEAR(d.terms[0].z, 2.0, 1e-12);
  EXPECT_NEAR(d.terms[1].z, -1.0, 1e-12);
  EXPECT_NEAR(d.value.value, std::sqrt((4.0 + 3.0) / 4.0), 1e-12);
  EXPECT_NEAR(d.value.low, d.value.value, 1e-12) << "replicates that are all the same";
  EXPECT_EQ(d.judged, 2U);
  EXPECT_EQ(terms(s), (std::vector<Term>{{0, 0}, {1, 1}}));
  EXPECT_EQ(term_name(s, {1, 1}), "f_mat_at_b");
}

TEST(Discrepancy, ATargetHoldsAtAllConditionsUnlessItSays) {
  const Study s = read("[[conditions]]\nlabel = \"a\"\n[[conditions]]\nlabel = \"b\"\necm.viscosity = 500\n" + target);
  EXPECT_EQ(terms(s), (std::vector<Term>{{0, 0}, {0, 1}}));
  EXPECT_EQ(term_name(read(target), {0, 0}), "f_mat");
  EXPECT_EQ(target_text(s.targets[0]), "0.5 +- 0.1");
}

TEST(Discrepancy, WhatIsNotDefinedIsLeftOutAndCounted) {
  const Study s = read(two_values + target);
  auto results = results_of("f_mat", {{0.7, not_known, 0.7}, {0.4, not_known, not_known}});
  const TargetJudge judge(s, results);
  const Discrepancy some = judge.discrepancy(0);
  EXPECT_EQ(some.terms[0].n, 2U);
  EXPECT_EQ(some.terms[0].undefined, 1U);
  EXPECT_NEAR(some.value.value, 2.0, 1e-12);
  const Discrepancy one = judge.discrepancy(1);
  EXPECT_EQ(one.judged, 0U) << "one run is too few";
  EXPECT_TRUE(std::isnan(one.value.value));
  EXPECT_TRUE(std::isnan(one.value.low));
  results[2].standing.status = RunState::failed;
  const Discrepancy failed = TargetJudge(s, results).discrepancy(0);
  EXPECT_EQ(failed.judged, 0U) << "what is not done has no value";
  EXPECT_EQ(failed.terms[0].undefined, 1U) << "and is not counted as undefined";
  EXPECT_EQ(ranking({one, some}), (std::vector<std::size_t>{1, 0})) << "what could not be judged comes last";
}

TEST(Discrepancy, ItsIntervalIsTheSameEachTimeAndDoesNotDependOnOtherSets) {
  const std::vector<double> x{0.4, 0.55, 0.6, 0.75, 0.8};
  const std::vector<Result> both = results_of("f_mat", {x, x});
  const Study small = read(two_values + target);
  const Study large = read("readouts = [\"f_mat\"]\n[sweep]\nprotrusion.number = [3, 1]\n" + target);
  const Discrepancy d = TargetJudge(small, both).discrepancy(0);
  const Discrepancy again = TargetJudge(large, results_of("f_mat", {{0.1, 0.2}, x})).discrepancy(1);
  EXPECT_LT(d.value.low, d.value.value);
  EXPECT_GT(d.value.high, d.value.value);
  EXPECT_EQ(again.value.low, d.value.low);
  EXPECT_EQ(again.value.high, d.value.high);
  const TargetJudge alone(small, both);
  EXPECT_NE(alone.draws(0), alone.draws(1)) << "each point is drawn for itself";
  const Study common = read("common_random_numbers = true\n" + two_values + target);
  const TargetJudge together(common, both);
  EXPECT_EQ(together.draws(0), together.draws(1)) << "replicates stay together";
  const Study other = read("seed = 2\n" + two_values + target);
  EXPECT_NE(TargetJudge(other, both).draws(0), alone.draws(0));
}

TEST(Discrepancy, ADrawIsJudgedByTheStandardErrorOfTheSample) {
  const std::vector<double> x{0.4, 0.55, 0.6, 0.75, 0.8};
  const Study s = read(two_values + target);
  const std::vector<double> draws = TargetJudge(s, results_of("f_mat", {x, x})).draws(0);
  const double standard_error = statistics::moments(x).sd / std::sqrt(5.0);
  const std::uint64_t key = run_seed(s.seed, s.points[0].settings, 0);
  for (std::size_t draw = 0; draw < 20; ++draw) {
    const auto drawn = statistics::picked(x, statistics::resampled(x.size(), key, draw));
    EXPECT_NEAR(draws[draw], std::abs(statistics::moments(drawn).mean - 0.5) / std::hypot(0.1, standard_error), 1e-12);
  }
}

TEST(Discrepancy, IsOfNoSetWithoutTargets) {
  EXPECT_TRUE(discrepancies(read(two_values), results_of("f_mat", {{0.7, 0.7}, {0.4, 0.4}})).empty());
  EXPECT_EQ(discrepancies(read(two_values + target), results_of("f_mat", {{0.7, 0.7}, {0.4, 0.4}})).size(), 2U);
}

TEST(Discrepancy, TableHasARowForEachSetFromTheBestOn) {
  const Study s = read("readouts = [\"f_mat\"]\n[sweep]\necm.youngs_modulus = [\"0.05 kPa\", \"100 Pa\"]\n"
                       "[[conditions]]\nlabel = \"thin\"\necm.viscosity = 500\n"
                       + target + "[[targets]]\nreadout = \"n_protrusions\"\nlow = 1\nhigh = 2\nerror = 1\n");
  const std::string csv = discrepancy_csv(s, discrepancies(s, results_of("f_mat", {{0.75, 0.75}, {0.625, 0.625}})));
  EXPECT_TRUE(csv.starts_with("rank,set,ecm.youngs_modulus_Pa,discrepancy,discrepancy_low,discrepancy_high,"
                              "targets_judged,targets,values_undefined,z_f_mat_at_thin,z_n_protrusions_at_thin,"
                              "mean_f_mat_at_thin,mean_n_protrusions_at_thin\n"
                              "1,youngs_modulus 100 Pa,100,1.25,1.25,1.25,1,2,2,1.25,,0.625,\n"
                              "2,youngs_modulus 50 Pa,50,2.5,2.5,2.5,1,2,2,2.5,,0.75,\n"))
      << csv;
}

} // namespace
} // namespace matrigrate::study
