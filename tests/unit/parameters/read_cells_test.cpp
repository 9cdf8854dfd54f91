#include "parameters/rules.hpp"
#include "parameters/schema.hpp"
#include "parameters/write.hpp"

#include "faults.hpp"

#include <gtest/gtest.h>

namespace matrigrate {
namespace {

const std::string two = "[[cells]]\nx = \"-20 um\"\ny = 0\n\n[[cells]]\nx = \"0.02 mm\"\ny = \"1 um\"\n";

TEST(ReadCells, WithoutAnyThereIsOneCell) {
  Parameters p = parse_parameters("cell.start_x = 3", "f.toml");
  EXPECT_TRUE(p.cells.empty());
  ASSERT_EQ(cell_starts(p).size(), 1U);
  EXPECT_EQ(cell_starts(p).front().x, 3.0);
  EXPECT_EQ(values_text(p).find("cells"), std::string::npos) << "the configuration hash of one cell";
  EXPECT_EQ(to_toml(p).find("[[cells]]"), std::string::npos);
}

TEST(ReadCells, EachTableIsACell) {
  const Parameters p = parse_parameters(two, "f.toml");
  ASSERT_EQ(p.cells.size(), 2U);
  EXPECT_EQ(p.cells[0].x, -20.0);
  EXPECT_EQ(p.cells[1].x, 20.0);
  EXPECT_EQ(p.cells[1].y, 1.0);
  EXPECT_TRUE(same(parse_parameters("cells = [{ x = -20, y = 0 }, { x = 20, y = 1 }]", "f.toml"), p));
  EXPECT_TRUE(same(parse_parameters("", "f.toml", {"cells=[{x = -20, y = 0}, {x = 20, y = 1}]"}), p));
  EXPECT_FALSE(same(parse_parameters("", "f.toml"), p));
}

TEST(ReadCells, TheResolvedScenarioGivesTheSameBits) {
  Parameters p = parse_parameters(two, "f.toml");
  p.cells[0].x = -20.1 / 0.7;
  const Parameters read = parse_parameters(to_toml(p), "f.toml");
  EXPECT_TRUE(same(read, p));
  EXPECT_EQ(read.cells[0].x, p.cells[0].x);
  EXPECT_EQ(values_text(read), values_text(p));
  EXPECT_NE(values_text(p), values_text(parse_parameters(two, "f.toml")));
}

TEST(ReadCells, TellsEveryFaultWithItsPlace) {
  EXPECT_EQ(
      faults_of("[[cells]]\nx = \"1 Pa\"\ny = 4000\n[[cells]]\nx = 1\nz = 2\n[[cells]]\nx = true\ny = 1\nradius = 3\n"),
      (std::vector<std::string>{
          "f.toml:2:5: cells[1].x: \"1 Pa\" is a stress, but a length is expected; write it like \"0 um\"",
          "f.toml:3:5: cells[1].y: 4000 um is out of range; allowed is >= -2000 and <= 2000 um",
          "f.toml:4:1: cells[2]: has no y; write it like y = \"40 um\"",
          "f.toml:6:1: cells[2].z: there is no such key; a cell has x and y; did you mean x?",
          "f.toml:8:5: cells[3].x: is a flag, but a number with its unit is expected, such as \"0 um\"",
          // NOLINTNEXTLINE(bugprone-suspicious-missing-comma): one text in two lines
          "f.toml:10:1: cells[3].radius: there is no such key; a cell has x and y; all cells are alike, with "
          "cell.radius of the section [cell]"}));
}

TEST(ReadCells, RefusesOtherForms) {
  const std::string form = "; write [[cells]] and below it x and y, for each cell";
  EXPECT_EQ(fault_of("[cells]\nx = 1\ny = 1\n"),
            "f.toml:1:1: cells: is a table, but an array of tables is expected" + form);
  EXPECT_EQ(fault_of("cells = 3"), "f.toml:1:9: cells: is a number, but an array of tables is expected" + form);
  EXPECT_EQ(fault_of("cells = [3]"), "f.toml:1:10: cells[1]: is a number, but a table is expected" + form);
  EXPECT_EQ(fault_of("cells = []"), "f.toml:1:9: cells: is empty; leave it out for one cell at cell.start_x, "
                                    "cell.start_y, or write [[cells]] and below it x and y, for each cell");
  EXPECT_EQ(fault_of("[[cell]]\nx = 1\ny = 1\n"),
            "f.toml:1:3: cell: is a section; write [cell] and its keys below, each on a line; several cells are "
            "[[cells]], with x and y each");
  std::string many;
  for (std::size_t k = 0; k <= max_cells; ++k) many += "[[cells]]\nx = 0\ny = 0\n";
  EXPECT_EQ(fault_of(many), "f.toml:1:1: cells: has 1001 cells; allowed are 1 to 1000");
}

TEST(ReadCells, CellsNeedRoom) {
  EXPECT_EQ(
      faults_of("[[cells]]\nx = 0\ny = 0\n[[cells]]\nx = 20\ny = 0\n[[cells]]\nx = 10\ny = 10\n[[cells]]\nx = 0\n"
                "y = -140\n"),
      (std::vector<std::string>{
          "f.toml:4:1: cells[2]: lies 20 um from cell 1, centre to centre; allowed is >= 31 um, two radii and the "
          "range of the repulsion of cells",
          "f.toml:7:1: cells[3]: lies 14.14 um from cell 1, centre to centre; allowed is >= 31 um, two radii and "
          "the range of the repulsion of cells",
          "f.toml:7:1: cells[3]: lies 14.14 um from cell 2, centre to centre; allowed is >= 31 um, two radii and "
          "the range of the repulsion of cells",
          "f.toml:10:1: cells[4]: lies 140 um from the centre of the disc, so the cell with its margin reaches "
          "the clamped rim; allowed is < 127.9 um, or a larger ecm.radius"}));
  EXPECT_TRUE(faults_of("[[cells]]\nx = 0\ny = 0\n[[cells]]\nx = 31\ny = 0\n").empty());
  EXPECT_EQ(fault_of(two + "[cell]\nstart_x = 4\n"),
            "f.toml:9:11: cell.start_x: is the start of a single cell, but [[cells]] gives the starts of all cells; "
            "leave this key out, or at 0");
}

TEST(ReadCells, AnOverrideThatTakesTheirRoomIsBlamed) {
  const Parameters p = parse_parameters(two, "f.toml");
  try {
    apply_overrides(p, {"cell.radius=25"});
    FAIL() << "the cells overlap";
  } catch (const ConfigurationError& error) {
    ASSERT_EQ(error.faults().size(), 1U);
    EXPECT_EQ(
        to_string(error.faults().front()),
        "--set: cell.radius: cell 2 lies 40.01 um from cell 1, centre to centre; allowed is >= 51 um, two radii and "
        "the range of the repulsion of cells");
  }
}

} // namespace
} // namespace matrigrate
