#include "study_report/run_curves.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "simulation/start.hpp"
#include "store/checkpoint.hpp"
#include "tables/csv.hpp"
#include "unit/study_plan/studies.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include <unistd.h>

namespace matrigrate::study {
namespace {

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

} // namespace
} // namespace matrigrate::study
