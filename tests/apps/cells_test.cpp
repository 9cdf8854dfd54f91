#include "program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace matrigrate {
namespace {

using nlohmann::json;

/// Two cells that touch, and one apart.
class Cells : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("three.toml", "[ecm]\nradius = \"75 um\"\n[protrusion]\ninitiation_rate = \"0.001 "
                        "1/s\"\n[contact.cells]\nadhesion = \"50 Pa\"\n"
                        "[output]\ntrack_interval = \"4 s\"\nfield_interval = \"10 s\"\n"
                        "[run]\nduration = \"60 s\"\nintegrator = \"adaptive\"\ntime_step = \"2 s\"\n"
                        "[[cells]]\nx = -32\ny = 0\n[[cells]]\nx = 0\ny = 0\n[[cells]]\nx = 40\ny = 0\n");
  }
  json record(const std::string& of) const { return json::parse(text_of(folder / of / "run.json")); }
};

TEST_F(Cells, WriteFilesThatTellThemApart) {
  ASSERT_EQ(run("run three.toml -o a --quiet").code, 0);
  const std::string group = text_of(folder / "a/group.csv");
  EXPECT_TRUE(
      group.starts_with("t_s,x_um,y_um,spread_um,speed_um_per_h,order,direction_deg,nearest_um,gap_um,n_contacts,"
                        "step\n"));
  EXPECT_EQ(std::ranges::count(group, '\n'), 17) << "a row every 4 s";
  EXPECT_EQ(std::ranges::count(text_of(folder / "a/tracks.csv"), '\n'), 1 + 3 * 16);
  EXPECT_EQ(std::ranges::count(text_of(folder / "a/summary.csv"), '\n'), 4);
  EXPECT_EQ(json::parse(text_of(folder / "a/summary.json")).at("cells").size(), 3U);
  EXPECT_EQ(run("report a").code, 0);
  EXPECT_EQ(run("diff a three.toml").code, 0);
}

TEST_F(Cells, HaveTheSameBitsForAnyNumberOfThreadsAndAfterARestart) {
  ASSERT_EQ(run("run three.toml -o a --quiet").code, 0);
  ASSERT_EQ(run("run a/scenario.resolved.toml -o b --quiet --threads 2").code, 0);
  EXPECT_EQ(record("a").at("trajectory_hash"), record("b").at("trajectory_hash"));
  EXPECT_EQ(record("a").at("configuration_hash"), record("b").at("configuration_hash"));
  EXPECT_EQ(text_of(folder / "a/group.csv"), text_of(folder / "b/group.csv"));
  ASSERT_EQ(run("run three.toml -o c --quiet --wall-time '0.05 s'").code, 75) << "stopped, to go on";
  ASSERT_EQ(run("resume c --quiet").code, 0);
  EXPECT_EQ(record("a").at("trajectory_hash"), record("c").at("trajectory_hash"));
  for (const char* file : {"tracks.csv", "group.csv", "health.csv", "protrusions.csv", "summary.json"})
    EXPECT_EQ(text_of(folder / "a" / file), text_of(folder / "c" / file)) << file;
}

TEST_F(Cells, CannotBeChangedInABranch) {
  ASSERT_EQ(run("run three.toml -o a --quiet").code, 0);
  const Ended ended = run("resume a --at '40 s' -o b --set 'cells=[{x = 0, y = 0}]'");
  EXPECT_EQ(ended.code, 3);
  EXPECT_TRUE(contains(ended.err, "cells: a branch keeps the cells of its run")) << ended.err;
}

TEST_F(Cells, AreRefusedWithEveryFault) {
  write("bad.toml", "[[cells]]\nx = 0\ny = 0\n[[cells]]\nx = 12\ny = 0\n[[cells]]\nx = 500\ny = 0\n");
  const Ended ended = run("run bad.toml");
  EXPECT_EQ(ended.code, 3);
  EXPECT_TRUE(contains(ended.err, "bad.toml:4:1: cells[2]: lies 12 um from cell 1")) << ended.err;
  EXPECT_TRUE(contains(ended.err, "bad.toml:7:1: cells[3]: lies 500 um from the centre of the disc")) << ended.err;
}

} // namespace
} // namespace matrigrate
