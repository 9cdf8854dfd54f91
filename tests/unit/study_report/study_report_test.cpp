#include "base/failure.hpp"
#include "base/file.hpp"
#include "parameters/schema.hpp"
#include "simulation/start.hpp"
#include "store/checkpoint.hpp"
#include "study_plan/names.hpp"
#include "study_report/drawn_study.hpp"
#include "study_report/study_files.hpp"
#include "tables/table.hpp"
#include "unit/study_plan/studies.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace matrigrate::study {
namespace {

const std::string two_points = "readouts = [\"f_mat\"]\n[[points]]\nlabel = \"soft, \\\"50\\\"\"\n"
                               "ecm.youngs_modulus = 50\n[[points]]\nlabel = \"stiff\"\necm.youngs_modulus = 400\n";

TEST(DrawnStudy, IsMadeOfReadOutsAndTables) {
  const Study study = read(two_points);
  std::vector<Result> results = results_of("f_mat", {{0.1, 0.2}, {0.3, 0.4}});
  results.back().standing.status = RunState::failed;
  const auto data = drawn_study(
      study, results,
      {.paths = "replicate,t_s,x_um,y_um,point\n1,0,0.00,0.00,\"soft, \"\"50\"\"\"\n1,600,1.00,-0.50,\"soft, "
                "\"\"50\"\"\"\n2,0,0.00,0.00,\"soft, \"\"50\"\"\"\n1,0,0.00,0.00,stiff\n1,600,7.00,0.00,stiff\n",
       .shapes = "replicate,x_um,y_um,point\n1,1.00,2.00,stiff\n1,3.00,4.00,stiff\n",
       .msd = "lag_s,msd_um2,sem_um2,n_runs,point\n600,10,,1,stiff\n1200,40,,1,stiff\n1800,90,,1,stiff\n",
       .adhesions = "replicate,length_um,f_mat,f_adh_rel,point\n1,28.00,0.700,0.100,stiff\n1,28,0.7,1.5,stiff\n"});
  EXPECT_EQ(data.at("axes").size(), 1U);
  EXPECT_EQ(data.at("groups").size(), 2U);
  ASSERT_EQ(data.at("runs").size(), 4U);
  EXPECT_EQ(data.at("runs").at(0).at("readouts").at("f_mat"), 0.1);
  EXPECT_EQ(data.at("runs").at(0).at("path").at("x_um").dump(), "[0.0,1.0]");
  EXPECT_EQ(data.at("runs").at(0).at("path").at("y_um").dump(), "[0.0,-0.5]");
  EXPECT_TRUE(data.at("runs").at(0).at("outline").is_null());
  EXPECT_EQ(data.at("runs").at(2).at("path").at("x_um").dump(), "[0.0,7.0]") << "of its own point";
  EXPECT_EQ(data.at("runs").at(2).at("outline").at("y_um").dump(), "[2.0,4.0]");
  EXPECT_EQ(data.at("runs").at(2).at("f_adh_rel").dump(), "[0.1,1.5]");
  EXPECT_TRUE(data.at("runs").at(3).at("readouts").empty()) << "it is not done";
  ASSERT_EQ(data.at("msd").size(), 1U) << "of points that have one";
  EXPECT_EQ(data.at("msd").at(0).at("point"), data.at("runs").at(2).at("point"));
  EXPECT_EQ(data.at("msd").at(0).at("lag_min").dump(), "[10.0,20.0,30.0]");
  EXPECT_TRUE(std::isnan(data.at("msd").at(0).at("sem_um2").at(0).get<double>()));
  EXPECT_NEAR(data.at("msd").at(0).at("slope").get<double>(), 2.0, 1e-12);
}

TEST(DrawnStudy, PathsOfSeveralCellsAreApart) {
  Study study = read(two_points);
  study.points[0].parameters.cells = {{-16.0, 0.0}, {16.0, 0.0}};
  const auto data = drawn_study(study, results_of("f_mat", {{0.1}, {}}),
                                {.paths = "replicate,t_s,x_um,y_um,cell,point\n1,0,0,0,1,\"soft, \"\"50\"\"\"\n"
                                          "1,600,-2,0,1,\"soft, \"\"50\"\"\"\n1,0,0,0,2,\"soft, \"\"50\"\"\"\n",
                                 .shapes = {},
                                 .msd = {},
                                 .adhesions = {}});
  EXPECT_EQ(data.at("runs").at(0).at("path").at("x_um").dump(), "[0.0,-2.0,null,0.0]");
}

TEST(DrawnStudy, NeedsNoTables) {
  const Study study = read(two_points);
  const auto data = drawn_study(study, results_of("f_mat", {{0.1}, {0.2}}), {});
  EXPECT_TRUE(data.at("msd").empty());
  EXPECT_TRUE(data.at("runs").at(0).at("path").is_null());
  EXPECT_THROW(drawn_study(study, {}, {.paths = "a,point\n1,stiff\n", .shapes = {}, .msd = {}, .adhesions = {}}),
               InputOutputError);
}

using Json = nlohmann::ordered_json;

tracks::CellTrack straight(std::uint32_t cell, double x, std::size_t positions) {
  tracks::CellTrack track{.cell = cell, .t = {}, .x = {}, .y = {}};
  for (std::size_t i = 0; i < positions; ++i) {
    track.t.push_back(60.0 * static_cast<double>(i));
    track.x.push_back(x + static_cast<double>(i));
    track.y.push_back(5.0);
  }
  return track;
}

TEST(MeasuredJson, TracksBeginAtTheOriginWithNullBetweenThem) {
  EXPECT_EQ(measured_json({straight(1, 10.0, 3), straight(2, -4.0, 2)}).dump(),
            R"({"total":2,"t_s":[0.0,60.0,120.0,null,0.0,60.0],"x_um":[0.0,1.0,2.0,null,0.0,1.0],)"
            R"("y_um":[0.0,0.0,0.0,null,0.0,0.0]})");
  EXPECT_TRUE(measured_json(std::vector<tracks::CellTrack>()).is_null());
}

TEST(MeasuredJson, ManyAreThinnedEvenly) {
  std::vector<tracks::CellTrack> many;
  for (int k = 0; k < 401; ++k) many.push_back(straight(k, 0.0, 1000));
  const Json json = measured_json(many);
  EXPECT_EQ(json.at("total"), 401);
  const Json& t = json.at("t_s");
  EXPECT_EQ(t.size(), 200U * 100U + 199U);
  EXPECT_EQ(t.at(99), 60.0 * 999) << "the last position of a track is kept";
}

TEST(MeasuredJson, TargetsTellWhichPointsTheyBelongTo) {
  Study study;
  study.conditions = {{"soft", {}}, {"stiff", {}}};
  study.points.resize(2);
  study.points[1].condition = 1;
  const auto soft = std::make_shared<const std::vector<tracks::CellTrack>>(2, straight(1, 0.0, 2));
  const auto both = std::make_shared<const std::vector<tracks::CellTrack>>(3, straight(1, 0.0, 2));
  study.targets = {{.readout = "a", .at = {0}, .tracks = soft},
                   {.readout = "b", .at = {0}, .tracks = soft},
                   {.readout = "c", .at = {}, .tracks = both},
                   {.readout = "d", .at = {}}};
  const Json list = measured_json(study, {straight(1, 0.0, 2)}, {Json{0}, Json{1}});
  ASSERT_EQ(list.size(), 3U) << "a file that two targets name counts once";
  EXPECT_EQ(list.at(0).at("points").dump(), "[[0],[1]]") << "those of the command line belong to all points";
  EXPECT_EQ(list.at(1).at("points").dump(), "[[0]]");
  EXPECT_EQ(list.at(2).at("points").dump(), "[[0],[1]]");
  EXPECT_EQ(tracks_at(study, {}, 0).size(), 5U);
  EXPECT_EQ(tracks_at(study, {}, 1).size(), 3U);
}

/// Two points, two runs each, the last one without files; a label with a comma and quotes.
class RunCurves : public ::testing::Test {
protected:
  RunCurves() {
    std::filesystem::remove_all(folder);
    for (const Result& r : results) {
      if (!r.standing.done()) continue;
      const std::filesystem::path run = run_folder(folder, r.run);
      std::filesystem::create_directories(run);
      const double end = static_cast<double>(r.run.replicate) + 10.0 * static_cast<double>(r.run.point);
      write_file(run / "tracks.csv", fmt::format("track,t_s,x_um,y_um\n1,0,5,5\n1,60,9,9\n1,600,{},5\n1,1200,{},4.5\n",
                                                 5.0 + end, 5.0 + 2.0 * end));
      write_file(run / "msd.csv", fmt::format("lag_s,msd_um2,samples\n600,{},2\n1200,{},1\n", end, 4.0 * end));
      write_file(run / "protrusions.csv",
                 fmt::format("id,length_um,f_mat,f_adh_rel,cause\n1,28,0.7,{},disassembly\n2,27.5,,,\n", 0.1 * end));
    }
  }
  ~RunCurves() override { std::filesystem::remove_all(folder); }

  static std::vector<Result> made() {
    std::vector<Result> all = results_of("f_mat", {{0.1, 0.2}, {0.3, 0.4}});
    all.back().standing.status = RunState::failed;
    return all;
  }
  std::filesystem::path folder = std::filesystem::temp_directory_path() / fmt::format("run-curves-{}", ::getpid());
  Study study =
      read("[[points]]\nlabel = \"soft, \\\"50\\\"\"\necm.youngs_modulus = 50\n[[points]]\nlabel = \"stiff\"\n"
           "ecm.youngs_modulus = 400\n");
  std::vector<Result> results = made();
};

TEST_F(RunCurves, PathsBeginAtTheOriginAndHaveARowEachTenMinutes) {
  const std::string csv = paths_csv(study, results, folder);
  EXPECT_EQ(csv, "replicate,t_s,x_um,y_um,point\n"
                 "1,0,0.00,0.00,\"soft, \"\"50\"\"\"\n1,600,1.00,0.00,\"soft, \"\"50\"\"\"\n"
                 "1,1200,2.00,-0.50,\"soft, \"\"50\"\"\"\n"
                 "2,0,0.00,0.00,\"soft, \"\"50\"\"\"\n2,600,2.00,0.00,\"soft, \"\"50\"\"\"\n"
                 "2,1200,4.00,-0.50,\"soft, \"\"50\"\"\"\n"
                 "1,0,0.00,0.00,stiff\n1,600,11.00,0.00,stiff\n1,1200,22.00,-0.50,stiff\n");
}

TEST_F(RunCurves, MeanSquareDisplacementsAreMeansOverRuns) {
  const std::vector<MeanMsd> soft = mean_msd(results, 0, folder);
  ASSERT_EQ(soft.size(), 2U);
  EXPECT_EQ(soft[0].mean, 1.5);
  EXPECT_EQ(soft[0].sem, 0.5);
  EXPECT_EQ(soft[1].mean, 6.0);
  const std::string csv = msd_csv(study, results, folder);
  EXPECT_TRUE(csv.starts_with("lag_s,msd_um2,sem_um2,n_runs,point\n600,1.5,0.5,2,\"soft")) << csv;
  EXPECT_NE(csv.find("\n600,11,,1,stiff\n"), std::string::npos) << csv;
}

TEST_F(RunCurves, ATableWithoutANeededColumnIsRefused) {
  const std::filesystem::path run = run_folder(folder, results[0].run);
  write_file(run / "msd.csv", "lag_s,samples\n600,2\n");
  EXPECT_THROW(mean_msd(results, 0, folder), InputOutputError);
  write_file(run / "protrusions.csv", "id,f_mat,f_adh_rel\n1,0.7,0.5\n");
  EXPECT_THROW(adhesions_csv(study, results, folder), InputOutputError);
}

TEST_F(RunCurves, OfSeveralCellsEachHasAPathAndARunCountsOnce) {
  study.points[0].parameters.cells = {{-16.0, 0.0}, {16.0, 0.0}};
  results.resize(1);
  const std::filesystem::path run = run_folder(folder, results[0].run);
  write_file(run / "tracks.csv", "track,t_s,x_um,y_um\n1,0,-16,0\n2,0,16,0\n1,600,-18,0\n2,600,16,5\n");
  write_file(run / "msd.csv", "cell,lag_s,msd_um2,samples\n1,600,4,1\n2,600,25,1\n");
  const std::string csv = paths_csv(study, results, folder);
  EXPECT_TRUE(csv.starts_with("replicate,t_s,x_um,y_um,cell,point\n1,0,0.00,0.00,1,")) << csv;
  EXPECT_NE(csv.find("\n1,600,-2.00,0.00,1,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\n1,600,0.00,5.00,2,"), std::string::npos) << csv;
  const std::vector<MeanMsd> means = mean_msd(results, 0, folder);
  ASSERT_EQ(means.size(), 1U);
  EXPECT_EQ(means[0].mean, 14.5);
  EXPECT_EQ(means[0].runs, 1U);
}

TEST_F(RunCurves, AdhesionsThatHaveEndedAreListed) {
  const std::string csv = adhesions_csv(study, results, folder);
  EXPECT_EQ(csv, "replicate,length_um,f_mat,f_adh_rel,point\n1,28.00,0.700,0.100,\"soft, \"\"50\"\"\"\n"
                 "2,28.00,0.700,0.200,\"soft, \"\"50\"\"\"\n1,28.00,0.700,1.100,stiff\n");
}

TEST_F(RunCurves, AStudyWithoutRunsHasEmptyTables) {
  const std::vector<Result> none;
  EXPECT_EQ(paths_csv(study, none, folder), "replicate,t_s,x_um,y_um,point\n");
}

TEST_F(RunCurves, ShapesAreTheOutlinesAtTheEndOfThreeRuns) {
  const std::vector<Result> four = results_of("f_mat", {{0.1, 0.2, 0.3, 0.4}, {0.5}});
  Parameters p;
  p.ecm.radius = 30.0;
  const State cell = initial_state(p);
  for (const Result& r : four) {
    State state = cell;
    for (std::size_t i = 0; i < state.cells[0].cortex.size(); ++i)
      state.cells[0].cortex.x[i] = {static_cast<double>(r.run.replicate), static_cast<double>(i)};
    std::filesystem::create_directories(run_folder(folder, r.run));
    store::write_checkpoint(run_folder(folder, r.run),
                            {.state = state, .scenario = "", .configuration_hash = "", .program = "", .memory = ""});
  }
  const std::string csv = shapes_csv(study, four, folder);
  const store::CsvTable table = store::read_csv(csv);
  const std::size_t shown = (cell.cells[0].cortex.size() + 1) / 2;
  ASSERT_EQ(table.rows.size(), 4 * shown) << "three replicates of the first point, one of the other";
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"1", "1.00", "2.00", "soft, \"50\""})) << "every second";
  EXPECT_EQ(table.rows[2 * shown], (std::vector<std::string>{"3", "3.00", "0.00", "soft, \"50\""}));
  EXPECT_EQ(table.rows.back()[3], "stiff");
}

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
  const auto data = study_data({"nowhere", study, {}}, {results, comparisons(study, results)});
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

TEST(StudyData, HoldsTargetsAtTheirConditions) {
  const Study study = read("readouts = [\"f_mat\"]\n[[conditions]]\nlabel = \"a\"\n[[conditions]]\nlabel = \"b\"\n"
                           "ecm.viscosity = 500\n[[targets]]\nreadout = \"f_mat\"\nlow = 0.5\nhigh = 1\nerror = 0.25\n"
                           "at = \"b\"\n[[targets]]\nreadout = \"n_protrusions\"\nvalue = 4\nerror = 1\n");
  const auto results = results_of("f_mat", {{}, {}});
  const auto data = study_data({"nowhere", study, {}}, {results, comparisons(study, results)});
  EXPECT_EQ(data.at("targets").dump(),
            "[{\"readout\":\"f_mat\",\"low\":0.5,\"high\":1.0,\"error\":0.25,\"at\":\"b\"},"
            "{\"readout\":\"n_protrusions\",\"low\":4.0,\"high\":4.0,\"error\":1.0,\"at\":\"\"}]");
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
  const auto data = study_data({"nowhere", study, {}}, {results, comparisons(study, results)});
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
  const auto data = study_data({"nowhere", study, {}}, {results, comparisons(study, results)});
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
  const std::string enough = study_data({"nowhere", study, {}}, {results, comparisons(study, results)}).at("summary");
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
    return study_data({"nowhere", study, {}}, {results, comparisons(study, results)}).at("status").get<std::string>();
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
      study_data({"nowhere", study, {}},
                 {.results = {},
                  .comparisons = {},
                  .claims = {{"A1", ClaimKind::predicted, "rises", "0.5", finding, {}, {}, "not the paper's runs"}}},
                 Json::parse(R"([{"id": "0", "label": "number 1", "run": {"format": "matrigrate-run"}}])"));
  const auto& claim = data.at("claims").at(0);
  EXPECT_EQ(claim.at("verdict"), "does not hold");
  EXPECT_EQ(claim.at("published"), "0.5");
  EXPECT_EQ(claim.at("ours").dump(), "[\"f_mat at 1 0.3 [0.2, 0.4] (n = 3)\"]");
  EXPECT_EQ(claim.at("statistic").at(0), "p 0.2: not met");
  EXPECT_EQ(claim.at("caveat"), "not the paper's runs");
  EXPECT_EQ(data.at("players").at(0).at("run").at("format"), "matrigrate-run");
}

} // namespace
} // namespace matrigrate::study
