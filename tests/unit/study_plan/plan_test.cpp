#include "unit/study_plan/studies.hpp"

#include "study_plan/sweep.hpp"

#include "parameters/write.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace matrigrate::study {
namespace {

std::vector<Run> runs_of(const Study& s) {
  return planned_runs(s, [](const Parameters& p) { return matrigrate::to_toml(p); });
}

/// Seeds by label and replicate.
std::map<std::pair<std::string, std::size_t>, std::uint64_t> seeds(const Study& s) {
  std::map<std::pair<std::string, std::size_t>, std::uint64_t> found;
  for (const Run& run : runs_of(s)) found[{s.points[run.point].label, run.replicate}] = run.seed;
  return found;
}

TEST(Plan, SeedsDoNotDependOnOtherPointsOrReplicates) {
  const auto few = seeds(read("[sweep]\necm.youngs_modulus = [50, 100]\n"));
  const auto many = seeds(parse_study("preset = \"baseline\"\nreplicates = 5\n[sweep]\necm.youngs_modulus = [\"0.1 "
                                      "kPa\", 400, 50]\n",
                                      "f.toml", "."));
  EXPECT_EQ(many.size(), 15U);
  for (const auto& [run, seed] : few) EXPECT_EQ(many.at(run), seed);
  EXPECT_NE(seeds(read("seed = 2\n[sweep]\necm.youngs_modulus = [50, 100]\n")), few);
}

TEST(Plan, SeedsDifferAndFitIntoADouble) {
  std::set<std::uint64_t> all;
  for (const auto& [run, seed] : seeds(read("[sweep]\necm.youngs_modulus = [50, 100]\nprotrusion.number = [0, 1]\n"))) {
    all.insert(seed);
    EXPECT_LE(seed, (std::uint64_t{1} << 53U) - 1);
  }
  EXPECT_EQ(all.size(), 12U);
  EXPECT_EQ(run_seed(1, {{"a", "1"}, {"b", "2"}}, 1), run_seed(1, {{"b", "2"}, {"a", "1"}}, 1));
}

TEST(Plan, SeedsDoNotDependOnTheFolderOfAFile) {
  const auto seed = [](const std::string& file) { return run_seed(1, {{"ecm.fields.youngs_modulus", file}}, 1); };
  EXPECT_EQ(seed("\"/a/E.csv column=b hash=12\""), seed("\"/b/c/E.csv column=b hash=12\""));
  EXPECT_NE(seed("\"/a/E.csv column=b hash=12\""), seed("\"/a/E.csv column=b hash=34\""));
}

TEST(Plan, CommonRandomNumbersAreTheSameAtEachPoint) {
  const Study s = read("common_random_numbers = true\n[sweep]\necm.youngs_modulus = [50, 100]\n");
  const auto runs = runs_of(s);
  for (std::size_t i = 0; i < runs.size(); i += 2) EXPECT_EQ(runs[i].seed, runs[i + 1].seed);
  EXPECT_NE(runs[0].seed, runs[2].seed);
  EXPECT_NE(runs[0].hash, runs[1].hash);
}

TEST(Plan, RunsComeReplicateByReplicate) {
  const auto runs = runs_of(read("[sweep]\necm.youngs_modulus = [50, 100]\n"));
  ASSERT_EQ(runs.size(), 6U);
  EXPECT_EQ(runs[1].point, 1U);
  EXPECT_EQ(runs[1].replicate, 1U);
  EXPECT_EQ(runs[2].replicate, 2U);
}

TEST(Sweep, AHypercubeMeetsEachStripOnce) {
  for (const std::size_t n : {1, 7, 50}) {
    std::set<std::size_t> strips;
    for (const double place : stratified(n, 3)) strips.insert(static_cast<std::size_t>(place * static_cast<double>(n)));
    EXPECT_EQ(strips.size(), n);
    EXPECT_LT(*strips.rbegin(), n);
  }
  EXPECT_EQ(stratified(9, 3), stratified(9, 3));
  EXPECT_NE(stratified(9, 3), stratified(9, 4));
}

TEST(Sweep, AHypercubeStaysInItsRanges) {
  const std::string one = "[latin_hypercube]\nsamples = 20\necm.youngs_modulus = [\"50 Pa\", \"400 Pa\"]\n";
  const Study s = read(one);
  const Study t =
      read(one + "protrusion.initiation_rate = [\"1e-5 1/s\", \"1e-3 1/s\", \"log\"]\nprotrusion.number = [1, 4]\n");
  ASSERT_EQ(t.points.size(), 20U);
  std::size_t low = 0;
  for (std::size_t i = 0; i < t.points.size(); ++i) {
    const Parameters& p = t.points[i].parameters;
    EXPECT_EQ(p.ecm.youngs_modulus, s.points[i].parameters.ecm.youngs_modulus) << "whatever else is sampled";
    EXPECT_GE(p.ecm.youngs_modulus, 0.05);
    EXPECT_LE(p.ecm.youngs_modulus, 0.4);
    EXPECT_GE(p.protrusion.number, 1);
    EXPECT_LE(p.protrusion.number, 4);
    low += p.protrusion.initiation_rate < 1e-4 ? 1 : 0;
  }
  EXPECT_EQ(low, 10U) << "half of a logarithmic range lies below its middle";
}

TEST(Sweep, AHypercubeMeetsEachStripOnceAlsoWhenItsValuesAreRounded) {
  for (const auto& [low, high] : {std::pair(200.0, 200.01), std::pair(50.0, 400.0)}) {
    const Study s = read(
        fmt::format("[latin_hypercube]\nsamples = 2000\necm.youngs_modulus = [\"{} Pa\", \"{} Pa\"]\n", low, high));
    ASSERT_EQ(s.points.size(), 2000U);
    std::set<long> strips;
    std::size_t usual = 0;
    for (const Point& point : s.points) {
      const std::string digits = point.settings.front().value; // "\"200.003 Pa\""
      strips.insert(std::lround(std::floor((std::stod(digits.substr(1)) - low) / (high - low) * 2000.0)));
      usual += digits.size() <= std::string("\"200.003 Pa\"").size() ? 1 : 0;
    }
    EXPECT_EQ(strips.size(), 2000U) << low;
    EXPECT_EQ(*strips.begin(), 0);
    EXPECT_EQ(*strips.rbegin(), 1999);
    if (high == 400.0) {
      EXPECT_GT(usual, 1980U) << "six digits, but near the ends of strips";
    }
  }
  const std::string fault = fault_of("[latin_hypercube]\nsamples = 2000\necm.youngs_modulus = [\"200 Pa\", "
                                     "\"200.0000000000002 Pa\"]\n");
  EXPECT_TRUE(fault.ends_with("the range is too narrow for 2000 different values; take fewer samples or a wider range"))
      << fault;
  const std::string repeated = fault_of("[latin_hypercube]\nsamples = 100\nprotrusion.number = [1, 4]\n");
  EXPECT_TRUE(repeated.ends_with("is the same as another point, and so are 95 more")) << repeated;
}

TEST(Sweep, EachFaultOfAHypercube) {
  EXPECT_TRUE(fault_of("[latin_hypercube]\necm.radius = [50, 60]\n").ends_with("is missing; write samples = 50"));
  EXPECT_TRUE(fault_of("[latin_hypercube]\nsamples = 3\n").ends_with("has no range of a parameter"));
  EXPECT_TRUE(fault_of("[latin_hypercube]\nsamples = 3\necm.radius = [60, 50]\n")
                  .ends_with("\"60 um\" is not below \"50 um\""));
  EXPECT_TRUE(
      fault_of("[latin_hypercube]\nsamples = 3\necm.radius = 50\n").ends_with("or [\"150 um\", \"150 um\", \"log\"]"));
  EXPECT_TRUE(fault_of("[latin_hypercube]\nsamples = 3\nadhesion.rupture = [false, true]\n")
                  .ends_with("is no number, and has no range"));
  EXPECT_TRUE(fault_of("[latin_hypercube]\nsamples = 3\nprotrusion.number = [0, 3, \"log\"]\n")
                  .ends_with("a logarithmic range must start above 0"));
}

} // namespace
} // namespace matrigrate::study
