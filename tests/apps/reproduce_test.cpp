#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>

namespace matrigrate {
namespace {

using nlohmann::json;

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
  EXPECT_TRUE(contains(ended.out, "stiffness: 60 of 60 runs done\n")) << ended.out;
  for (const char* name : {"claims.csv", "claims-A.csv", "report-A.html"})
    EXPECT_TRUE(exists(std::string("reproduce/") + name)) << name;
  EXPECT_FALSE(exists("reproduce/stiffness")) << "no study is run";
  EXPECT_TRUE(contains(file("reproduce/claims.csv"),
                       "id,kind,claim,published,ours,verdict,why_not,verdict_in_larger_disc,against,caveat\n"));
}

TEST_F(Reproduce, TellsWhatIsWrongWithKeptResults) {
  EXPECT_EQ(run("reproduce A --from nowhere").code, 5);
  std::filesystem::create_directory(folder / "kept");
  write("kept/stiffness-results.csv", "a,b\n");
  const Ended ended = run("reproduce A5 --from kept");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "stiffness-results.csv: has no column run")) << ended.err;
  EXPECT_EQ(run("reproduce D1 --from kept").code, 4) << "undecided: no results of that study are kept";
  for (const char* of_runs :
       {"--replicates 3", "--set ecm.radius=40", "--integrator reference", "--jobs 2", "--kept kept"})
    EXPECT_EQ(run(std::string("reproduce A5 --from kept ") + of_runs).code, 2) << of_runs;
}

TEST_F(Reproduce, RefusesResultsOfOtherParameters) {
  std::filesystem::create_directory(folder / "kept");
  std::string results = text_of(kept / "stiffness-results.csv");
  results.replace(results.find('\n') + 1, 16, "0123456789abcdef");
  write("kept/stiffness-results.csv", results);
  const Ended ended = run("reproduce A5 --from kept");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "run 0123456789abcdef does not belong to the study")) << ended.err;
}

TEST_F(Reproduce, MakesRunsThatEndAtTheRimAgainInALargerDisc) {
  const Ended ended = run("reproduce A5 --replicates 2 --quiet --set 'ecm.radius=40 um' --set 'run.duration=0.1 h'"
                          " --set protrusion.number=1");
  EXPECT_EQ(ended.code, 4) << ended.err;
  EXPECT_TRUE(contains(ended.out, "stiffness: 0 of 10 runs done; 10 ended at the rim\n")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "made again in a larger disc: undecided")) << ended.out;
  const std::string larger = file("reproduce/stiffness-larger-disc/scenario.resolved.toml");
  EXPECT_TRUE(contains(larger, "radius = \"60 um\"")) << larger;
  EXPECT_TRUE(contains(page_data("reproduce/report-A5.html"), "made again in a larger disc: undecided"));
  const auto runs = std::filesystem::directory_iterator(folder / "reproduce/stiffness-larger-disc/runs");
  EXPECT_EQ(std::count_if(begin(runs), end(runs), [](const auto& one) { return one.is_directory(); }), 4)
      << "those of 200 and 400 Pa, on which A5 depends";
}

TEST_F(Reproduce, GoesOnFromKeptResults) {
  const std::string few = "reproduce A5 --replicates 1 --quiet --set 'ecm.radius=40 um' --set 'run.duration=0.1 h'"
                          " --set protrusion.number=1";
  ASSERT_EQ(run(few + " -o here").code, 4);
  const std::string table = file("here/stiffness/results.csv");
  std::filesystem::create_directory(folder / "kept");
  write("kept/stiffness-larger-disc-results.csv", file("here/stiffness-larger-disc/results.csv"));
  std::string part = table; // all but the last row
  const std::size_t status = part.rfind(",failed,");
  ASSERT_NE(status, std::string::npos) << table;
  part.replace(status, 8, ",missing,");
  write("kept/stiffness-results.csv", part);

  ASSERT_EQ(run(few + " -o there --kept kept").code, 4);
  const auto made = [&](const char* runs) {
    const auto entries = std::filesystem::directory_iterator(folder / runs);
    return std::count_if(begin(entries), end(entries), [](const auto& one) { return one.is_directory(); });
  };
  EXPECT_EQ(made("there/stiffness/runs"), 1) << "the one that is missing";
  EXPECT_EQ(made("there/stiffness-larger-disc/runs"), 0) << "all of them are kept";
  EXPECT_EQ(file("there/stiffness/results.csv"), table);
  EXPECT_EQ(file("there/claims-A5.csv"), file("here/claims-A5.csv"));

  part.replace(part.find('\n') + 1, 16, "0123456789abcdef");
  write("kept/stiffness-results.csv", part);
  const Ended other = run(few + " -o other --kept kept");
  EXPECT_EQ(other.code, 5);
  EXPECT_TRUE(contains(other.err, "run 0123456789abcdef does not belong to the study")) << other.err;
  EXPECT_EQ(run(few + " --kept nowhere").code, 5);
}

TEST_F(Reproduce, KeptVerdictsFollowFromKeptTables) {
  run("reproduce all -o again --from '" + kept.string() + "'");
  EXPECT_EQ(file("again/claims.csv"), text_of(kept / "claims.csv")) << "write it again, with tools/keep_results.sh";
  EXPECT_EQ(file("again/claims-all.csv"), text_of(kept / "conditions.csv"));
  run("reproduce X -o more --from '" + kept.string() + "'");
  EXPECT_EQ(file("more/claims.csv"), text_of(kept / "experiments.csv"));
  std::set<std::string> studies;
  for (const auto& entry : std::filesystem::directory_iterator(kept))
    if (const std::string name = entry.path().filename(); name.ends_with("-paths.csv"))
      studies.insert(name.substr(0, name.size() - 10));
  std::size_t drawn = 0; // X rows, which may be kept as well, are left out of all
  const json page = json::parse(page_data("again/report-all.html"));
  for (const json& one : page.at("studies")) {
    if (!studies.contains(one.at("name"))) continue;
    ++drawn;
    for (const json& run : one.at("study").at("runs"))
      EXPECT_EQ(run.at("path").is_null(), run.at("status") != "done") << one.at("name");
  }
  EXPECT_GE(drawn, 3U);
}

TEST_F(Reproduce, DrawsOnlyWhatBelongsToTheChosenRows) {
  run("reproduce A5 -o one --from '" + kept.string() + "'");
  const json page = json::parse(page_data("one/report-A5.html"));
  ASSERT_EQ(page.at("statements").size(), 1U);
  EXPECT_EQ(page.at("statements").at(0).at("studies").dump(), "[\"stiffness\"]");
  ASSERT_EQ(page.at("studies").size(), 1U);
  EXPECT_EQ(page.at("studies").at(0).at("name"), "stiffness");
}

TEST_F(Reproduce, NamesWhereWhatIsNoClaimIsChecked) {
  for (const char* row : {"V", "V1", "V2", "V3"}) {
    const Ended ended = run(std::string("reproduce ") + row);
    EXPECT_EQ(ended.code, 2) << row;
    EXPECT_TRUE(contains(ended.err, "matrigrate validate fibres fibres-uniaxial disassembly")) << ended.err;
  }
  EXPECT_TRUE(contains(run("reproduce F1").err, "F1 is no row any more: the page of a run plays both fields"));
  EXPECT_FALSE(exists("reproduce"));
}

} // namespace
} // namespace matrigrate
