#include "study_runs/study_folder.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "study_runs/pool.hpp"
#include "unit/study_plan/studies.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

namespace matrigrate::study {
namespace {

namespace fs = std::filesystem;

class StudyFolders : public testing::Test {
protected:
  void TearDown() override { fs::remove_all(m_root); }

  StudyFolder two_points() const { return planned(read("[sweep]\necm.youngs_modulus = [50, 200]\n"), m_root / "s"); }

  fs::path m_root = fs::path(testing::TempDir()) / ("matrigrate_study_" + std::to_string(::getpid()));
};

TEST_F(StudyFolders, HoldTheStudyThatWasWritten) {
  const StudyFolder study = two_points();
  ASSERT_EQ(study.runs.size(), 6U);
  make_study_folder(study);
  write_study(study);
  const StudyFolder again = open_study(study.folder);
  ASSERT_EQ(again.runs.size(), study.runs.size());
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    EXPECT_EQ(again.runs[i].hash, study.runs[i].hash);
    EXPECT_EQ(standing(again.folder, again.runs[i]).status, RunState::missing);
  }
}

/// Users have folders of these names. A program that calls the runs otherwise would not find them, so no version may
/// change what is here: a new parameter has `before` in its row.
TEST(RunsOfStudies, KeepTheirNames) {
  struct Named {
    std::string preset, set, name;
  };
  const std::vector<Named> named{
      {"baseline", "", "e7de854255ac1e86"},
      {"two-cells", "", "ccd24237484f6cdd"},
      {"fibrillar", "", "3e3383b27c20ff1a"},
      {"two-protrusions-fibres", "", "2254448763db9619"},
      {"stiffness-gradient", "", "c2741f084aafbb9d"},
      {"chemotaxis", "", "60f280ed0776db55"},
      {"two-cells", "contact.cells.adhesion=\"20 Pa\"", "030951d69a0bcf00"},
      {"second-closures", "", "d436f2c98f0bb7fc"}, // of version 0.2.0, whose baseline it is
      {"second-closures", "nucleus.radius = \"5 um\"", "c1d8f5a21bda4811"},
      {"second-closures", "protrusion.deflection_cone = \"37 deg\"", "3dfe7833d82c1979"},
      {"second-closures", "adhesion.hold=\"matter\"", "d436f2c98f0bb7fc"},
  };
  for (const Named& one : named) {
    const std::string text = fmt::format("preset = \"{}\"\nreplicates = 1\n[set]\n{}\n", one.preset, one.set);
    EXPECT_EQ(planned(parse_study(text, "f.toml", "."), {}).runs.at(0).hash, one.name) << text;
  }
}

TEST_F(StudyFolders, OfOtherFilesAreRefused) {
  fs::create_directories(m_root / "s");
  write_file(m_root / "s" / "letter.txt", "x");
  EXPECT_THROW(make_study_folder(two_points()), InputOutputError);
  EXPECT_THROW(open_study(m_root / "s"), InputOutputError);
}

TEST_F(StudyFolders, AreNamedAfterTheirFile) {
  EXPECT_EQ(default_study_folder("a/stiffness.toml"), "stiffness-study");
  EXPECT_EQ(default_study_folder("a/study.resolved.toml"), "a");
}

TEST_F(StudyFolders, GiveEachRunItsCommand) {
  const StudyFolder study = two_points();
  const std::vector<std::string> command = run_command(study, study.runs.front(), 2);
  const auto has = [&](const std::string& word) { return std::ranges::find(command, word) != command.end(); };
  EXPECT_EQ(command[1], "run");
  EXPECT_TRUE(std::ranges::any_of(command, [](const auto& word) { return word.starts_with("ecm.youngs_modulus="); }))
      << fmt::format("{}", fmt::join(command, " "));
  EXPECT_TRUE(has(fmt::format("{}", study.runs.front().seed)));
  EXPECT_TRUE(has(run_folder(study.folder, study.runs.front()).string()));
}

TEST_F(StudyFolders, CostAsMuchAsTheirRuns) {
  const StudyCost c = cost(two_points());
  ASSERT_EQ(c.run_times.size(), 2U);
  EXPECT_NEAR(c.wall_time, 3.0 * (c.run_times[0] + c.run_times[1]), 1e-9 * c.wall_time);
  EXPECT_EQ(c.looked_at, 2U);
}

TEST_F(StudyFolders, HaveRunsThatAreNotComputedAgain) {
  const StudyFolder study = two_points();
  make_study_folder(study);
  for (const study::Run& run : study.runs) { // not testing::Test::Run
    fs::create_directories(run_folder(study.folder, run));
    const bool first = run.hash == study.runs.front().hash;
    write_file(run_folder(study.folder, run) / "run.json",
               first ? R"({"status": "failed", "exit_code": 4, "reason": "why", "cause": "rim"})"
                     : R"({"status": "done"})");
    write_file(run_folder(study.folder, run) / "summary.json", "{}");
    write_file(run_log(study.folder, run), "");
  }
  const auto watch = [](auto...) -> int { throw std::logic_error("there is nothing to compute"); };
  const PoolOutcome outcome = compute(study, {0, 1, 2, 3, 4, 5}, {}, watch);
  EXPECT_EQ(outcome.done_before, 5U);
  ASSERT_EQ(outcome.troubles.size(), 1U);
  EXPECT_EQ(outcome.troubles[0].status, RunState::failed);
  EXPECT_EQ(outcome.troubles[0].reason, "why");
  EXPECT_TRUE(fs::exists(run_log(study.folder, study.runs.front())));
  EXPECT_FALSE(fs::exists(run_log(study.folder, study.runs.back()))) << "left by a pool that was killed";
}

} // namespace
} // namespace matrigrate::study
