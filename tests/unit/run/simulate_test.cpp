#include "run/simulate.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "run/folder_state.hpp"
#include "run/resume.hpp"
#include "simulation/start.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

namespace matrigrate::run {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view page =
    "<html><script type=\"application/json\" id=\"matrigrate-data\">null</script></html>\n";

/// A cell in a small gel, for twelve steps of the reference integrator.
Parameters small() {
  Parameters p;
  p.ecm.radius = 40.0;
  p.run.integrator = Integrator::reference;
  p.run.time_step = 0.4;
  p.run.duration = 4.8;
  p.output.track_interval = 0.8;
  p.output.field_interval = 1.6;
  return p;
}

/// Notes what it is told, and asks for a stop after some steps.
class Notes : public RunObserver {
public:
  explicit Notes(int stop_after = 1000) : m_stop_after(stop_after) {}
  void warn(std::string_view text) override { warnings.emplace_back(text); }
  void begin() override { told += "b"; }
  void begin_steps(double /*t*/, double /*t_end*/) override { told += "<"; }
  void end_steps() override { told += ">"; }
  void step(const State& /*s*/) override { ++steps; }
  std::optional<StopRequest> stop_request() override {
    return steps < m_stop_after ? std::nullopt : std::optional(StopRequest::user);
  }

  std::vector<std::string> warnings;
  std::string told;
  int steps = 0;

private:
  int m_stop_after;
};

class Run : public testing::Test {
protected:
  void SetUp() override { fs::create_directories(m_root); }
  void TearDown() override { fs::remove_all(m_root); }

  /// Options for a new folder.
  RunOptions in(const std::string& name) const {
    fs::create_directories(m_root / name);
    return {.folder = m_root / name, .command_line = {"matrigrate", "run", "small.toml"}, .page_template = page};
  }

  static RunOutcome start(const RunOptions& options, RunObserver& observer) {
    const Parameters p = small();
    return run({.s = initial_state(p), .p = p}, options, observer);
  }

  /// The hash of a run that nobody stops.
  std::string whole_hash() const {
    Notes notes;
    return start(in("whole"), notes).record.at("trajectory_hash");
  }

  fs::path m_root = fs::path(testing::TempDir()) / ("matrigrate_run_" + std::to_string(::getpid()));
};

TEST_F(Run, GoesToItsEndAndLeavesItsFiles) {
  Notes notes;
  const RunOutcome outcome = start(in("a"), notes);
  EXPECT_EQ(outcome.end, RunEnd::completed);
  EXPECT_TRUE(outcome.computed);
  EXPECT_EQ(outcome.record.at("status"), "done");
  EXPECT_EQ(outcome.record.at("scenario"), "small");
  EXPECT_EQ(outcome.record.at("steps"), 12);
  EXPECT_EQ(outcome.sentence, "Done: 4.8 s, 12 steps.");
  EXPECT_NEAR(outcome.cells.at(0).readouts.duration, 4.8, 1e-9);
  EXPECT_EQ(record_of(m_root / "a"), outcome.record);
  for (const char* file : {"scenario.resolved.toml", "tracks.csv", "protrusions.csv", "health.csv", "msd.csv",
                           "summary.json", "fields.h5", "checkpoint.h5", "report.html"})
    EXPECT_TRUE(fs::is_regular_file(m_root / "a" / file)) << file;
  EXPECT_FALSE(fs::exists(m_root / "a" / "fields.part"));
}

TEST_F(Run, TellsItsObserver) {
  Notes notes;
  start(in("a"), notes);
  EXPECT_EQ(notes.told, "b<>");
  EXPECT_EQ(notes.steps, 12);
  EXPECT_TRUE(notes.warnings.empty());
}

TEST_F(Run, WritesNoReportWithoutATemplate) {
  Notes notes;
  RunOptions options = in("a");
  options.page_template = {};
  start(options, notes);
  EXPECT_TRUE(fs::exists(m_root / "a" / "summary.json"));
  EXPECT_FALSE(fs::exists(m_root / "a" / "report.html"));
}

TEST_F(Run, StopsWhenAskedAndResumesToTheSameBits) {
  Notes first(5);
  const RunOptions options = in("a");
  const RunOutcome stopped = start(options, first);
  EXPECT_EQ(stopped.end, RunEnd::stopped_by_user);
  EXPECT_EQ(stopped.record.at("status"), "interrupted");
  EXPECT_EQ(stopped.record.at("exit_code"), 130);
  EXPECT_EQ(first.steps, 5);
  Notes second;
  const RunOutcome outcome = resume(options, ResumeOptions{}, second);
  EXPECT_EQ(outcome.end, RunEnd::completed);
  EXPECT_EQ(second.steps, 7);
  ASSERT_EQ(outcome.record.at("lineage").size(), 1U);
  EXPECT_EQ(outcome.record.at("lineage")[0].at("event"), "resumed");
  EXPECT_EQ(outcome.record.at("trajectory_hash"), whole_hash());
  EXPECT_EQ(read_file(m_root / "a" / "tracks.csv", 1U << 20U), read_file(m_root / "whole" / "tracks.csv", 1U << 20U));
}

TEST_F(Run, DoesNotGoOnFromTheCheckpointOfAnotherScenario) {
  Notes first(5);
  start(in("a"), first);
  Parameters other = small();
  other.ecm.youngs_modulus *= 2.0;
  Notes second(5);
  run({.s = initial_state(other), .p = other}, in("b"), second);
  fs::copy_file(m_root / "b" / "checkpoint.h5", m_root / "a" / "checkpoint.h5", fs::copy_options::overwrite_existing);
  Notes third;
  try {
    resume(in("a"), ResumeOptions{}, third);
    ADD_FAILURE() << "a checkpoint of another scenario was taken";
  } catch (const InputOutputError& refused) {
    EXPECT_NE(std::string(refused.what()).find("is a checkpoint of another scenario than"), std::string::npos)
        << refused.what();
  }
  EXPECT_EQ(third.steps, 0);
}

TEST_F(Run, StopsAtTheLimitOfWallTime) {
  Notes notes;
  RunOptions options = in("a");
  options.wall_time_limit = 0.0;
  const RunOutcome outcome = start(options, notes);
  EXPECT_EQ(outcome.end, RunEnd::out_of_wall_time);
  EXPECT_EQ(outcome.record.at("exit_code"), 75);
  EXPECT_EQ(notes.steps, 1);
  EXPECT_NE(outcome.sentence.find("the limit of wall time"), std::string::npos);
}

TEST_F(Run, IsLeftAsItIsWhenDone) {
  Notes notes;
  const RunOptions options = in("a");
  start(options, notes);
  EXPECT_TRUE(look_at(options.folder, small(), notes).has(Holds::this_run));
  const RunOutcome again = resume(options, small(), notes);
  EXPECT_FALSE(again.computed);
  EXPECT_EQ(again.end, RunEnd::completed);
  EXPECT_EQ(again.record.at("status"), "done");
  EXPECT_EQ(notes.steps, 12);
}

TEST_F(Run, StartsAgainWhereItWasEndedBeforeItsFirstCheckpoint) {
  Notes notes;
  EXPECT_EQ(resume(in("a"), small(), notes).end, RunEnd::completed);
  EXPECT_EQ(notes.steps, 12);
}

TEST_F(Run, RecordsANumericalFailure) {
  Notes notes;
  Parameters p = small();
  p.run.time_step = 40.0; // far above the largest stable one
  p.run.duration = 4000.0;
  const RunOutcome outcome = run({.s = initial_state(p), .p = p}, in("a"), notes);
  EXPECT_EQ(outcome.end, RunEnd::numerical_failure);
  EXPECT_EQ(record_of(m_root / "a").at("status"), "failed");
  EXPECT_EQ(record_of(m_root / "a").at("exit_code"), 4);
  EXPECT_EQ(outcome.sentence.rfind("Failed after ", 0), 0U) << outcome.sentence;
}

TEST_F(Run, BranchesWithOtherParameters) {
  Notes notes;
  start(in("a"), notes);
  RunOptions options = in("b");
  options.folder = m_root / "b" / "branch"; // made by the branch
  const RunOutcome outcome = branch(m_root / "a", {.overrides = {"run.duration=8 s"}, .at = 2.4}, options, notes);
  EXPECT_EQ(outcome.end, RunEnd::completed);
  EXPECT_EQ(outcome.record.at("t_s"), 8.0);
  EXPECT_EQ(outcome.record.at("lineage")[0].at("event"), "branched");
  EXPECT_EQ(outcome.record.at("lineage")[0].at("at_s"), 2.4);
}

} // namespace
} // namespace matrigrate::run
