#include "program.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace matrigrate {
namespace {

const std::filesystem::path root = MATRIGRATE_SOURCE_DIR;
const std::filesystem::path kept = root / "docs/validation";
/// Judges by the results that are kept with the program.
class Reproduce : public Program {
protected:
  std::string file(const std::string& name) const { return text_of(folder / name); }
};

TEST_F(Reproduce, JudgesKeptResultsWithoutARun) {
  const Ended ended = run("reproduce A --from '" + kept.string() + "'");
  EXPECT_TRUE(contains(ended.out, "A5   calibration  holds ")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "stiffness: 60 of 60 runs done; 0 ended at the rim, 0 by crossing themselves"))
      << ended.out;
  for (const char* name : {"claims.csv", "claims-A.csv", "report-A.html", "stiffness.svg", "stiffness-paths.svg"})
    EXPECT_TRUE(exists(std::string("reproduce/") + name)) << name;
  EXPECT_FALSE(exists("reproduce/stiffness")) << "no study is run";
  EXPECT_TRUE(contains(file("reproduce/claims.csv"),
                       "id,kind,claim,published,ours,verdict,why_not,verdict_in_larger_disc,caveat\n"));
}

TEST_F(Reproduce, TellsWhatIsWrongWithKeptResults) {
  EXPECT_EQ(run("reproduce A --from nowhere").code, 5);
  std::filesystem::create_directory(folder / "kept");
  write("kept/stiffness-results.csv", "a,b\n");
  const Ended ended = run("reproduce A5 --from kept");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "stiffness-results.csv: has no column run")) << ended.err;
  EXPECT_EQ(run("reproduce D1 --from kept").code, 4) << "undecided: no results of that study are kept";
  EXPECT_EQ(run("reproduce V1 --from kept").code, 4) << "nor of that case";
  for (const char* of_runs : {"--replicates 3", "--set ecm.radius=40", "--integrator reference", "--jobs 2"})
    EXPECT_EQ(run(std::string("reproduce A5 --from kept ") + of_runs).code, 2) << of_runs;
  EXPECT_EQ(run("reproduce A5 --json --markdown").code, 2);
}

TEST_F(Reproduce, RefusesResultsOfOtherParameters) {
  std::filesystem::create_directory(folder / "kept");
  std::string results = text_of(kept / "stiffness-results.csv");
  results.replace(results.find('\n') + 1, 16, "0123456789abcdef");
  write("kept/stiffness-results.csv", results);
  const Ended ended = run("reproduce A5 --from kept");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "run 0123456789abcdef is not one of the study")) << ended.err;
}

TEST_F(Reproduce, MakesRunsThatEndAtTheRimAgainInALargerDisc) {
  const Ended ended = run("reproduce A5 --replicates 2 --quiet --set 'ecm.radius=40 um' --set 'run.duration=0.1 h'"
                          " --set protrusion.number=1");
  EXPECT_EQ(ended.code, 4) << ended.err;
  EXPECT_TRUE(contains(ended.out, "stiffness: 0 of 10 runs done; 10 ended at the rim, 0 by crossing themselves"))
      << ended.out;
  EXPECT_TRUE(contains(ended.out, "made again in a larger disc: ")) << ended.out;
  const std::string larger = file("reproduce/stiffness-larger-disc/scenario.resolved.toml");
  EXPECT_TRUE(contains(larger, "radius = \"60 um\"")) << larger;
  EXPECT_TRUE(contains(file("reproduce/report-A5.html"), "made again in a larger disc: "));
  const auto runs = std::filesystem::directory_iterator(folder / "reproduce/stiffness-larger-disc/runs");
  EXPECT_GE(std::distance(begin(runs), end(runs)), 10);
}

TEST_F(Reproduce, PagesSayWhatTheKeptResultsGive) {
  const std::string table = run("reproduce all --markdown --from '" + kept.string() + "'").out;
  const std::string validation = text_of(root / "docs/validation.md");
  ASSERT_GT(table.size(), 1000U);
  EXPECT_NE(validation.find(table.substr(0, table.find("\n\n"))), std::string::npos)
      << "write the table of docs/validation.md again: matrigrate reproduce all --markdown --from docs/validation\n"
      << table;
  const std::string bottom = table.substr(table.find("\n\n") + 2);
  const std::string line = bottom.substr(0, bottom.find_last_not_of(".\n") + 1);
  for (const char* page : {"docs/validation.md", "README.md"})
    EXPECT_NE(text_of(root / page).find(line), std::string::npos) << page << " does not say: " << line;
}

TEST_F(Reproduce, KeptFiguresAreDrawnFromKeptTables) {
  run("reproduce all -o drawn --from '" + kept.string() + "'");
  EXPECT_EQ(file("drawn/claims.csv"), text_of(kept / "claims.csv"));
  std::size_t figures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "drawn")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".svg" || name.starts_with("boxes-")) continue;
    ++figures;
    EXPECT_TRUE(text_of(entry.path()) == text_of(kept / name))
        << name << ": write it again, with tools/keep_results.sh";
  }
  EXPECT_GE(figures, 4U);
}

TEST_F(Reproduce, DrawsOnlyWhatBelongsToTheChosenRows) {
  run("reproduce A5 -o one --from '" + kept.string() + "'");
  EXPECT_TRUE(exists("one/stiffness.svg"));
  for (const auto& entry : std::filesystem::directory_iterator(folder / "one"))
    EXPECT_FALSE(entry.path().filename().string().starts_with("validate-")) << entry.path();
}

} // namespace
} // namespace matrigrate
