#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "observe/readout_table.hpp"
#include "run/cadence.hpp"
#include "run/estimate.hpp"
#include "run/finished_run.hpp"
#include "run/run_record.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace matrigrate::run {
namespace {

TEST(Cadence, IsDueOnceAtEachMultipleHoweverTimesAreRounded) {
  const double below = std::nextafter(0.3, 0.0);
  const double above = std::nextafter(0.3, 1.0);
  for (const double t : {below, 0.3, above}) {
    Cadence cadence(0.3, 0.1);
    EXPECT_TRUE(cadence.due(0.0));
    EXPECT_FALSE(cadence.due(0.1));
    EXPECT_FALSE(cadence.due(0.2));
    EXPECT_TRUE(cadence.due(t));
    EXPECT_FALSE(cadence.due(t)) << t;
    EXPECT_FALSE(cadence.due(0.4)) << t;
    EXPECT_TRUE(cadence.due(0.6));
  }
}

TEST(Cadence, IsDueOnceAfterALongStepAndThenAtMultiplesAgain) {
  Cadence cadence(2.0, 1.0);
  EXPECT_TRUE(cadence.due(0.0));
  EXPECT_TRUE(cadence.due(7.0)); // those at 2, 4 and 6 are past
  EXPECT_FALSE(cadence.due(7.5));
  EXPECT_TRUE(cadence.due(8.0));
}

TEST(Cadence, OfNoIntervalIsNeverDue) {
  Cadence cadence(0.0, 1.0);
  EXPECT_FALSE(cadence.due(0.0));
  EXPECT_FALSE(cadence.due(100.0));
}

class ReadOutsOfTables : public testing::Test {
protected:
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }

  double value(std::string_view name) const {
    std::vector<double> values(readout_table().size(), std::numeric_limits<double>::quiet_NaN());
    add_from_tables(folder, values);
    return values[static_cast<std::size_t>(find_readout(name) - readout_table().data())];
  }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("matrigrate-readouts-of-tables-" + std::to_string(::getpid()));
  std::string track_header = "track,t_s,x_um,y_um,area_um2,perimeter_um,polarization_rad,n_simultaneous,n_growing,"
                             "n_maturing,n_contracting,n_finishing,n_initiated,step\n";
};

TEST_F(ReadOutsOfTables, AreThoseThatAnEndedRunTells) {
  write_file(folder / "tracks.csv", track_header
                                        + "1,0,0,0,1,1,,1,1,0,0,0,0,0\n2,0,30,0,1,1,,2,2,0,0,0,0,0\n"
                                          "1,600,-3,4,1,1,,1,1,0,0,0,0,9\n2,600,30,5,1,1,,1,1,0,0,0,0,9\n");
  write_file(folder / "protrusions.csv",
             "cell,id,f_adh_rel,cause\n1,1,0.2,disassembly\n1,2,0.9,rupture\n2,1,0.9,rupture\n2,2,,\n");
  write_file(folder / "group.csv",
             "t_s,x_um,y_um,spread_um,speed_um_per_h,order,direction_deg,nearest_um,gap_um,n_contacts,step\n"
             "0,1,1,1,,,,30,,1,0\n600,1,1,1,1,0.75,1,33,,0,9\n");
  EXPECT_DOUBLE_EQ(value("share_f_adh_rel_low"), 0.25) << "mean of the cells' 1/2 and 0";
  EXPECT_DOUBLE_EQ(value("share_2_or_3_protrusions"), 0.25);
  EXPECT_DOUBLE_EQ(value("migration_index_x"), (-3.0 / 5.0 + 0.0) / 2.0);
  EXPECT_DOUBLE_EQ(value("parting_index"), (3.0 / 5.0 + 0.0) / 2.0);
  EXPECT_DOUBLE_EQ(value("share_in_contact"), 0.5);
  EXPECT_DOUBLE_EQ(value("nearest_um"), 33.0);
  EXPECT_DOUBLE_EQ(value("order"), 0.75);
  EXPECT_TRUE(std::isnan(value("f_mat"))) << "is in the summary";
}

TEST_F(ReadOutsOfTables, NeedWholeTables) {
  write_file(folder / "protrusions.csv", "id,f_adh_rel,cause\n");
  EXPECT_THROW(value("order"), InputOutputError) << "no tracks.csv";
  write_file(folder / "tracks.csv", "t_s,x_um\n0,0\n");
  EXPECT_THROW(value("order"), InputOutputError) << "another table";
  write_file(folder / "tracks.csv", track_header + "1,0,0,0,1,1,,1,1,0,0,0,0,0\n1,600,3,4,1,1,,1,1,0,0,0,0,9\n");
  EXPECT_DOUBLE_EQ(value("migration_index_x"), 0.6);
  EXPECT_TRUE(std::isnan(value("order"))) << "a single cell has no group";
  write_file(folder / "protrusions.csv", "id\n1\n");
  EXPECT_THROW(value("order"), InputOutputError) << "no f_adh_rel";
}

TEST(RunStatus, IsReadAsItIsWritten) {
  for (const RunStatus status : {RunStatus::running, RunStatus::done, RunStatus::failed, RunStatus::interrupted})
    EXPECT_EQ(parse_run_status(to_string(status)), status);
  EXPECT_FALSE(parse_run_status(""));
  EXPECT_FALSE(parse_run_status("Done"));
}

TEST(RunEnd, HasAStatusAndAnExitCode) {
  EXPECT_EQ(status_of(RunEnd::completed), RunStatus::done);
  for (const RunEnd end : {RunEnd::numerical_failure, RunEnd::no_memory, RunEnd::cannot_write})
    EXPECT_EQ(status_of(end), RunStatus::failed);
  for (const RunEnd end : {RunEnd::stopped_by_user, RunEnd::told_to_terminate, RunEnd::out_of_wall_time})
    EXPECT_EQ(status_of(end), RunStatus::interrupted);
  EXPECT_EQ(exit_code(RunEnd::stopped_by_user), 130);
  EXPECT_EQ(exit_code(RunEnd::out_of_wall_time), 75);
}

TEST(RunRecord, HasNoExitCodeWhileItRuns) {
  RunRecord record;
  EXPECT_EQ(to_json(record, {}).at("status"), "running");
  EXPECT_TRUE(to_json(record, {}).at("exit_code").is_null());
  record.ended = RunEnd::numerical_failure;
  EXPECT_EQ(to_json(record, {}).at("status"), "failed");
  EXPECT_EQ(to_json(record, {}).at("exit_code"), 4);
}

TEST(RunRecord, TellsTheStatusThatItHolds) {
  EXPECT_EQ(status_of(nlohmann::ordered_json{{"status", "interrupted"}}), RunStatus::interrupted);
  EXPECT_FALSE(status_of(nlohmann::ordered_json{{"status", 3}}));
  EXPECT_FALSE(status_of(nlohmann::ordered_json()));
}

TEST(ConfigurationHash, IsTheSameForAnyNumberOfThreadsOnly) {
  Parameters p;
  const std::string of_one = configuration_hash(p);
  p.run.threads = 2;
  EXPECT_EQ(configuration_hash(p), of_one);
  ++p.run.seed;
  EXPECT_NE(configuration_hash(p), of_one);
}

TEST(Threads, AreThoseAskedForOrThosePayingOnIdleCores) {
  Parameters p;
  p.run.threads = 3;
  EXPECT_EQ(threads_of(p, 1000), 3);
  p.run.threads = 0;
  EXPECT_EQ(threads_of(p, 7999), 1) << "a small matrix";
  EXPECT_EQ(threads_that_pay(17'665), 2);
  EXPECT_EQ(threads_that_pay(282'697), 4);
  EXPECT_LE(threads_of(p, 282'697), hardware_threads());
  EXPECT_GE(threads_of(p, 282'697), 1);
}

} // namespace
} // namespace matrigrate::run
