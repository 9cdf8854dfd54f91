#include "study_report/study_data.hpp"

#include "parameters/schema.hpp"
#include "study_plan/names.hpp"
#include "study_report/discrepancy_json.hpp"
#include "tables/csv.hpp"
#include "unit/study_plan/studies.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

TEST(StudyData, AxesHoldTimesThatAreNoShortDecimalOfTheirUnit) {
  const nlohmann::ordered_json axes = axes_json(read("[sweep]\nrun.duration = [\"22 min\", \"0.5 h\"]\n"));
  ASSERT_EQ(axes.size(), 1U);
  EXPECT_EQ(axes.at(0).at("unit"), "h");
  EXPECT_DOUBLE_EQ(axes.at(0).at("values").at(0).get<double>(), 22.0 / 60.0);
  EXPECT_EQ(axes.at(0).at("values").at(1), 0.5);
}

TEST(StudyData, FieldsAreValuesOfAnAxis) {
  const nlohmann::ordered_json axes = axes_json(read("[[points]]\nlabel = \"gel\"\n[[points]]\nlabel = \"track\"\n"
                                                     "ecm.fields.f_degr = \"abs(y) < 5 ? 0 : 1\"\n"));
  ASSERT_EQ(axes.size(), 1U);
  EXPECT_EQ(axes.at(0).at("values").dump(), "[\"none\",\"abs(y) < 5 ? 0 : 1\"]");
}

TEST(StudyData, PointsThatAreNoGridHaveTheirLabelsAsAnAxis) {
  const nlohmann::ordered_json samples =
      axes_json(read("[latin_hypercube]\nsamples = 5\necm.youngs_modulus = [50, 400]\necm.viscosity = [500, 1000]\n"));
  ASSERT_EQ(samples.size(), 1U);
  EXPECT_EQ(samples.at(0).at("values").at(4), "sample 5");
  const Study study = read("[[points]]\nlabel = \"base\"\n[[points]]\nadhesion.rupture = true\n[[points]]\n"
                           "protrusion.number = 2\n[[points]]\necm.viscosity = 500\n[[points]]\nprotrusion.force = 1\n"
                           "[[conditions]]\nlabel = \"soft\"\necm.youngs_modulus = 50\n[[conditions]]\n"
                           "label = \"stiff\"\necm.youngs_modulus = 400\n");
  const nlohmann::ordered_json axes = axes_json(study);
  ASSERT_EQ(axes.size(), 2U);
  EXPECT_EQ(axes.at(0).at("values").dump(),
            "[\"base\",\"rupture true\",\"n_prot 2\",\"viscosity 500 Pa s\",\"force 1 nN\"]");
  EXPECT_EQ(axes.at(1).at("values").dump(), "[\"soft\",\"stiff\"]");
  EXPECT_EQ(places(study).at(3).dump(), "[1,1]");
  EXPECT_EQ(places(read("[sweep]\nprotrusion.number = [2, 1]\n")).at(0).dump(), "[1]") << "a grid, in order";
}

TEST(StudyData, TellsParametersApartThatEndAlike) {
  const Study study = read("readouts = [\"f_mat\"]\n[latin_hypercube]\nsamples = 5\nprotrusion.force = [0.1, 0.2]\n"
                           "actomyosin.force = [1, 2]\n");
  auto results = results_of("f_mat", {{1.0, 1.1, 1.2}, {2.0}, {3.0}, {4.0}, {5.0, 5.1, 5.2}});
  for (Result& r : results) r.standing.status = RunState::running; // there are no tables of runs to read
  const auto data = study_data({study, results, comparisons(study, results), "nowhere", "commit"});
  EXPECT_EQ(data.at("scatter").at("factors").at(0).at("label"), "protrusion.force (F_prot)");
  EXPECT_EQ(data.at("scatter").at("factors").at(1).at("label"), "actomyosin.force (F_am)");
  EXPECT_EQ(data.at("scatter").at("factors").at(1).at("meaning"), find_row("actomyosin.force")->description);
  const std::string summary = data.at("summary");
  for (const char* name : {"protrusion.force 0.1", "actomyosin.force 1"})
    EXPECT_NE(summary.find(name), std::string::npos) << summary;
  const nlohmann::ordered_json axes =
      axes_json(read("[set]\nnucleus.radius = \"5 um\"\n[sweep]\ncell.bending_stiffness = [\"1e-18 N m\"]\n"
                     "nucleus.bending_stiffness = [0.1, 0.2]\n"));
  EXPECT_EQ(axes.at(0).at("label"), "k_bend");
  EXPECT_EQ(axes.at(1).at("label"), "nucleus.bending_stiffness") << "has no letters";
}

TEST(StudyData, HoldsTargetsAndDistances) {
  const Study study = read("readouts = [\"f_mat\"]\n[[points]]\nlabel = \"base\"\n[[points]]\nadhesion.rupture = true\n"
                           "[[targets]]\nreadout = \"f_mat\"\nlow = 0.5\nhigh = 1\nerror = 0.25\n");
  const std::vector<Result> results = results_of("f_mat", {{0.25, 0.25, 0.25}, {1.5, 1.5, 1.5}});
  const std::vector<Discrepancy> found = discrepancies(study, results);
  const nlohmann::ordered_json json = discrepancy_json(study, found);
  EXPECT_EQ(json.at("targets").at(0).at("target"), "0.5 to 1 +- 0.25");
  EXPECT_EQ(json.at("sets").at(0).at("label"), "base");
  EXPECT_EQ(json.at("sets").at(0).at("z").dump(), "[-1.0]");
  EXPECT_EQ(json.at("sets").at(1).at("settings"), "rupture true");
  EXPECT_EQ(json.at("sets").at(1).at("discrepancy"), 2.0);
  EXPECT_EQ(json.at("sets").at(1).at("interval").dump(), "[2.0,2.0]");
  EXPECT_EQ(discrepancy_sentence(study, found), " The discrepancy is least, 1 (1 to 1), at base.");
  const Study plain = read("");
  EXPECT_TRUE(discrepancy_json(plain, {}).is_null());
  EXPECT_EQ(discrepancy_sentence(plain, {}), "");
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
  EXPECT_TRUE(data.at("correlation").is_null()) << "nothing varies yet";
}

TEST(StudyData, BoxesAreThoseOfGroupsCsv) {
  const Study study = read("readouts = [\"f_mat\"]\n[sweep]\nprotrusion.number = [1, 2]\n");
  std::vector<Result> results = results_of("f_mat", {{0.1, 0.25, 0.6, 0.7}, {0.5}});
  for (Result& r : results) r.standing.status = RunState::running; // there are no tables of runs to read
  const auto data = study_data({study, results, comparisons(study, results), "nowhere", "commit"});
  ASSERT_EQ(data.at("groups").size(), 2U);
  const std::string csv = groups_csv(study, results);
  for (const char* name : {"mean", "low_whisker", "low_quartile", "median", "high_quartile", "high_whisker"})
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(data.at("groups").at(i).at(name).get<double>(), store::csv_column(csv, name).at(i)) << name;
  EXPECT_EQ(data.at("groups").at(0).at("low_quartile"), 0.2125) << "linear between order statistics";
  EXPECT_EQ(data.at("groups").at(1).at("n"), 1);
  EXPECT_TRUE(data.at("tests").at(0).contains("p_holm"));
  EXPECT_EQ(data.at("summary"),
            "Maturation of protrusions, mean (f_mat) goes from 0.412 to 0.5 over 2 points; of fewer than 3 runs none "
            "is called the lowest or the highest.");
  results = results_of("f_mat", {{0.1, 0.25, 0.6, 0.7}, {0.5, 0.6, 0.7}});
  for (Result& r : results) r.standing.status = RunState::running;
  const std::string enough =
      study_data({study, results, comparisons(study, results), "nowhere", "commit"}).at("summary");
  EXPECT_TRUE(enough.starts_with(
      "Maturation of protrusions, mean (f_mat) is lowest, 0.412 (mean of 4 runs) at n_prot 1, and highest, "
      "0.6 (mean of 3 runs) at n_prot 2; "))
      << enough;
}

TEST(StudyData, SaysThatRunsEndedAtTheRim) {
  const Study study = read("readouts = [\"f_mat\"]\n[sweep]\nprotrusion.number = [1, 2]\n");
  std::vector<Result> results = results_of("f_mat", {{0.1, 0.2}, {0.5}});
  for (Result& r : results) r.standing.status = RunState::running;
  const auto status = [&] {
    return study_data({study, results, comparisons(study, results), "nowhere", "commit"})
        .at("status")
        .get<std::string>();
  };
  EXPECT_EQ(status(), "0 of 3 runs done.");
  results[2].standing.status = RunState::failed;
  results[2].standing.cause = FailureCause::rim;
  EXPECT_EQ(status(), "0 of 3 runs done. " + rim_text(study, results));
}

TEST(StudyData, HoldsClaimsAndPlayedRuns) {
  const Study study = read("[sweep]\nprotrusion.number = [1, 2]\n");
  const Finding finding{Verdict::does_not_hold, {"f_mat at 1 0.3 [0.2, 0.4] (n = 3)"}, {"p 0.2: not met"}};
  const auto data =
      study_data({.study = study,
                  .results = {},
                  .comparisons = {},
                  .folder = "nowhere",
                  .provenance = "commit",
                  .claims = {{"A1", ClaimKind::predicted, "rises", "0.5", finding, {}, {}, "not the paper's runs"}},
                  .claims_note = "Not run as published.",
                  .played = {{"0", "number 1", {{"format", "matrigrate-run"}}}}});
  const auto& claim = data.at("claims").at(0);
  EXPECT_EQ(claim.at("verdict"), "does not hold");
  EXPECT_EQ(claim.at("published"), "0.5");
  EXPECT_EQ(claim.at("ours").dump(), "[\"f_mat at 1 0.3 [0.2, 0.4] (n = 3)\"]");
  EXPECT_EQ(claim.at("statistic").at(0), "p 0.2: not met");
  EXPECT_EQ(data.at("claims_note"), "Not run as published.");
  EXPECT_EQ(claim.at("caveat"), "not the paper's runs");
  EXPECT_EQ(data.at("players").at(0).at("run").at("format"), "matrigrate-run");
}

} // namespace
} // namespace matrigrate::study
