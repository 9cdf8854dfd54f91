#include "run/run_record.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace matrigrate::run {
namespace {

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

} // namespace
} // namespace matrigrate::run
