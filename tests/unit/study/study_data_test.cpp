#include "study/study_data.hpp"

#include "studies.hpp"

#include <gtest/gtest.h>

namespace matrigrate::study {
namespace {

TEST(StudyData, AxesHoldValuesInOrder) {
  const Study study = read("[sweep]\necm.youngs_modulus = [\"200 Pa\", \"50 Pa\"]\n"
                           "ecm.lattice = [\"square\", \"hexagonal\"]\n");
  const nlohmann::ordered_json axes = axes_json(study);
  ASSERT_EQ(axes.size(), 2U);
  EXPECT_EQ(axes.at(0).at("name"), "ecm.youngs_modulus");
  EXPECT_EQ(axes.at(0).at("unit"), "Pa");
  EXPECT_EQ(axes.at(0).at("values").dump(), "[50.0,200.0]");
  EXPECT_EQ(axes.at(1).at("values").dump(), "[\"square\",\"hexagonal\"]");
  EXPECT_EQ(axes_json(read("")).size(), 1U) << "a study of one point";
}

TEST(StudyData, HoldsRunsThatAreNotThereYet) {
  const Study study = read("[sweep]\necm.youngs_modulus = [\"200 Pa\", \"50 Pa\"]\n");
  const auto runs = planned_runs(study, [](const Parameters&) { return std::string("0"); });
  std::vector<Result> results;
  for (const auto& run : runs) {
    Result& result = results.emplace_back();
    result.run = run;
    result.readouts.assign(all_readouts().size(), std::numeric_limits<double>::quiet_NaN());
  }
  const auto data = study_data({study, results, comparisons(study, results), "nowhere", "commit"});
  EXPECT_EQ(data.at("format"), "matrigrate-study");
  ASSERT_EQ(data.at("runs").size(), 6U);
  EXPECT_EQ(data.at("runs").at(0).at("status"), "pending");
  EXPECT_EQ(data.at("runs").at(0).at("point").dump(), "[1]") << "200 Pa is drawn after 50 Pa";
  EXPECT_EQ(data.at("msd").size(), 2U);
  EXPECT_EQ(data.at("correlation").at("names").size(), study.readouts.size());
}

} // namespace
} // namespace matrigrate::study
