#include "base/failure.hpp"
#include "faults.hpp"
#include "parameters/assign.hpp"
#include "parameters/document.hpp"
#include "parameters/nearest.hpp"
#include "parameters/presets.hpp"
#include "parameters/read.hpp"
#include "parameters/rules.hpp"
#include "parameters/schema.hpp"
#include "parameters/units.hpp"
#include "parameters/version.hpp"
#include "parameters/write.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

using namespace matrigrate;

namespace matrigrate {
namespace {

Closures of(const std::vector<std::string>& overrides) { return closures_of(apply_overrides({}, overrides)); }

TEST(Closures, EveryPresetButOneIsOfTheThirdSet) {
  for (const Preset& preset : presets()) {
    const Closures closures = closures_of(parameters_of(preset));
    EXPECT_EQ(closures.text, preset.name == "second-closures" ? "second set" : "third set") << preset.name;
    EXPECT_EQ(closures.note.empty(), preset.name != "second-closures");
  }
}

TEST(Closures, TheFirstSetIsKnownByItsNumbers) {
  const Closures closures =
      of({"cell.bending_stiffness=5e-17 N m", "contact.fluid_share=0.1", "contact.body_fluid_share=0.1",
          "protrusion.least_facing=0.8", "adhesion.rest_speed=0 nm/s",
          "laws.curvature_factor=max(0, 1 - abs(kappa - kappa_0)/kappa_w)"});
  EXPECT_EQ(closures.text, "first set");
  EXPECT_NE(closures.note.find("tag closures-2"), std::string::npos);
}

/// As a scenario of version 0.2.0 that `new` wrote.
TEST(Closures, ValuesOfTwoSetsAreMixed) {
  const Closures closures = of({"cell.bending_stiffness=5e-17 N m", "contact.fluid_share=0.15"});
  EXPECT_TRUE(closures.text.starts_with("mixed: "));
  const std::string text = closures.text;
  EXPECT_NE(text.find("; of the second cell.bending_stiffness = \"5e-17 N m\", contact.fluid_share = 0.15"),
            std::string::npos)
      << text;
  for (const char* key :
       {"contact.body_fluid_share", "protrusion.least_facing", "adhesion.rest_speed", "laws.curvature"})
    EXPECT_LT(text.find(key), text.find("; of the second")) << key << ": " << text;
  EXPECT_NE(closures.note.find("--preset second-closures"), std::string::npos);
  const std::string three = of({"contact.fluid_share=0.1", "protrusion.least_facing=0.8"}).text;
  EXPECT_NE(three.find("; of the second protrusion.least_facing = 0.8; of the first contact.fluid_share = 0.1"),
            std::string::npos)
      << three;
}

TEST(Closures, AValueOfNoSetChangesNone) {
  EXPECT_EQ(of({"adhesion.rest_speed=2 nm/s"}).text, "third set, but for adhesion.rest_speed = \"2 nm/s\"");
  EXPECT_EQ(of({"adhesion.rest_speed=2 nm/s"}).note, "");
  EXPECT_EQ(of({"ecm.youngs_modulus=50 Pa", "adhesion.zeta_diss=80 1/nN"}).text, "third set");
}

} // namespace
} // namespace matrigrate

namespace matrigrate::units {
namespace {

std::string refusal(const char* name, const char* wanted) {
  try {
    factor_of_column(name, wanted);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ColumnUnit, IsConvertedToTheWantedOne) {
  EXPECT_EQ(factor_of_column("E_Pa", "Pa"), 1.0);
  EXPECT_EQ(factor_of_column("E_kPa", "Pa"), 1000.0);
  EXPECT_EQ(factor_of_column("mean_E_MPa", "Pa"), 1e6);
  EXPECT_EQ(factor_of_column("E (kPa)", "Pa"), 1000.0);
  EXPECT_EQ(factor_of_column("E [nN/um^2]", "Pa"), 1000.0);
  EXPECT_DOUBLE_EQ(factor_of_column("direction_rad", "deg"), 180.0 / std::numbers::pi);
  EXPECT_EQ(factor_of_column("direction_deg", "deg"), 1.0);
}

TEST(ColumnUnit, IsNoneWhereANameHasNone) {
  for (const char* name : {"E", "E_mean", "f_degr", "E_1", "E_s", "kPa", "E (AFM)", "", "_", "()"})
    EXPECT_EQ(factor_of_column(name, "Pa"), 1.0) << name;
}

TEST(ColumnUnit, IsRefusedIfItIsOfAnotherKindOrMisspelt) {
  EXPECT_EQ(refusal("height_um", "Pa"), "column height_um is in um; wanted is Pa");
  EXPECT_EQ(refusal("E_kPa", "1"), "column E_kPa is in kPa; wanted is a number without a unit");
  EXPECT_EQ(refusal("E_kpa", "Pa"), "column E_kpa: kpa is no unit; did you mean kPa?");
  EXPECT_EQ(refusal("E_kilopascal", "Pa"), "column E_kilopascal: kilopascal is no unit; did you mean kPa?");
}

} // namespace
} // namespace matrigrate::units

namespace matrigrate {
namespace {

std::vector<Fault> raised(FaultList& list) {
  try {
    list.raise();
  } catch (const ConfigurationError& error) {
    return error.faults();
  }
  return {};
}

TEST(FaultList, NothingIsRaisedWithoutFaults) {
  FaultList list("f");
  EXPECT_TRUE(list.empty());
  EXPECT_NO_THROW(list.raise());
}

TEST(FaultList, TheFirstByPlaceAreKeptWhateverTheirOrder) {
  FaultList list("f");
  list.add({"--set", 0, 0, "last", "m"});
  for (int i = 5000; i > 0; --i) list.add({"f", i, 1, fmt::format("k{}", i), "m"});
  const auto faults = raised(list);
  ASSERT_EQ(faults.size(), FaultList::max_listed + 1);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(faults[static_cast<std::size_t>(i)].line, i + 1);
  EXPECT_EQ(to_string(faults.back()), "f: has 4801 more faults");
}

TEST(FaultList, AFaultIsNotedOnce) {
  FaultList list("f");
  for (int i = 0; i < 3000; ++i) list.add({"f", i % 3 + 1, 1, "k", "m"});
  EXPECT_EQ(raised(list).size(), 3U);
}

TEST(FaultList, HintsAreMadeForListedFaultsOnly) {
  FaultList list("f");
  int made = 0;
  for (int i = 0; i < 60'000; ++i)
    list.add({"f", i + 1, 1, "k", "m"}, [&made] {
      ++made;
      return std::string("; hint");
    });
  EXPECT_EQ(made, 0);
  EXPECT_EQ(to_string(raised(list).front()), "f:1:1: k: m; hint");
  EXPECT_EQ(made, 200);
}

double number(const char* path, const char* text) {
  const Judged found = judged(path, {text, "a string"});
  EXPECT_EQ(found.fault, "") << path;
  return found.number;
}

TEST(Judge, GivesNumbersInTheDocumentedUnit) {
  EXPECT_EQ(number("ecm.youngs_modulus", "0.05 kPa"), 50.0);
  EXPECT_EQ(number("run.duration", "6 h 30 min"), 6.5);
  EXPECT_EQ(number("cells.y", "-0.02 mm"), -20.0);
  EXPECT_EQ(number("ecm.lattice", "square"), 0.0) << "is no number";
}

TEST(Judge, HasTheWordsOfTheReader) {
  EXPECT_EQ(judged("ecm.youngs_modulus", {"50 s", "a string"}).fault,
            "\"50 s\" is a time, but a stress is expected; write it like \"200 Pa\"");
  EXPECT_EQ(judged("ecm.youngs_modulus", {std::numeric_limits<double>::quiet_NaN(), "a number"}).fault,
            "nan is not a finite number");
  EXPECT_EQ(judged("ecm.youngs_modulus", {{}, "an array"}).fault,
            "is an array, but a number with its unit is expected, such as \"200 Pa\"");
  EXPECT_EQ(judged("ecm.youngs_modulu", {1.0, "a number"}).fault,
            "there is no such parameter; did you mean ecm.youngs_modulus?");
  EXPECT_EQ(unknown_name("emc", true), "there is no such section; did you mean ecm?");
}

TEST(Nearest, EditDistanceCountsSlips) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("abc", "abc"), 0u);
  EXPECT_EQ(edit_distance("ABC", "abc"), 0u);
  EXPECT_EQ(edit_distance("abc", "abd"), 1u);
  EXPECT_EQ(edit_distance("abc", "acb"), 1u) << "two swapped letters are one slip";
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(Nearest, OnlyNearNamesAreOffered) {
  const std::vector<std::string> names{"check", "explain", "new"};
  EXPECT_EQ(nearest("chek", names), "check");
  EXPECT_EQ(nearest("exlpain", names), "explain");
  EXPECT_EQ(nearest("simulate", names), std::nullopt);
  EXPECT_EQ(nearest("", names), std::nullopt);
  EXPECT_EQ(nearest(std::string(100000, 'x'), names), std::nullopt);
}

TEST(Nearest, ParametersAreFoundByMoreThanSpelling) {
  EXPECT_EQ(nearest_parameter("ecm.youngs_modulu"), "ecm.youngs_modulus");
  EXPECT_EQ(nearest_parameter("ecm.Youngs_Modulus"), "ecm.youngs_modulus");
  EXPECT_EQ(nearest_parameter("youngs_modulus"), "ecm.youngs_modulus") << "without its section";
  EXPECT_EQ(nearest_parameter("cell.youngs_modulus"), "ecm.youngs_modulus") << "in a wrong section";
  EXPECT_EQ(nearest_parameter("ecm.max_iterations"), "solver.max_iterations");
  EXPECT_EQ(nearest_parameter("ecm.E"), "ecm.youngs_modulus") << "the paper's symbol";
  EXPECT_EQ(nearest_parameter("emc"), "ecm") << "a section";
  EXPECT_EQ(nearest_parameter("ecm.colour"), std::nullopt);
}

TEST(Nearest, WordsThatPeopleTryAreKnown) {
  EXPECT_EQ(nearest_parameter("ecm.stiffness"), "ecm.youngs_modulus") << "not fibres.stiffness";
  EXPECT_EQ(nearest_parameter("stiffness"), "ecm.youngs_modulus");
  EXPECT_EQ(nearest_parameter("fibre.stiffness"), "fibres.stiffness") << "another section: by its letters";
  EXPECT_EQ(nearest_parameter("run.hours"), "run.duration");
  EXPECT_EQ(nearest_parameter("time.hours"), "run.duration");
  EXPECT_EQ(nearest_parameter("cell.contractility"), "actomyosin.force");
}

TEST(Nearest, ResultsAreNoParameters) {
  const std::string speed = "; it is a result, the read-out v_migr_abs_um_per_h, and cannot be set";
  EXPECT_EQ(parameter_hint("speed"), speed);
  EXPECT_EQ(parameter_hint("cell.speed"), speed) << "not run.seed";
  EXPECT_EQ(parameter_hint("ecm.velocity"), speed);
  EXPECT_EQ(parameter_hint("ecm.stiffness"), "; did you mean ecm.youngs_modulus?");
  EXPECT_EQ(parameter_hint("ecm.colour"), "");
}

TEST(Nearest, AliasesLeadToParameters) {
  for (const std::string_view word :
       {"ecm.elasticity", "ecm.elastic_modulus", "ecm.modulus", "ecm.rigidity", "ecm.domain_radius",
        "ecm.poisson_ratio", "ecm.resolution", "run.time", "run.end_time", "run.step", "cell.contraction",
        "cell.diameter", "cell.size", "fibers.orientation"}) {
    const auto meant = nearest_parameter(word);
    ASSERT_TRUE(meant) << word;
    EXPECT_NE(find_row(*meant), nullptr) << word;
  }
}

} // namespace
} // namespace matrigrate

namespace nucleus_test {

namespace {

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

} // namespace

TEST(NucleusParameters, AreOffAndLeaveTheFingerprintAlone) {
  EXPECT_EQ(Parameters{}.nucleus.radius, 0.0);
  Parameters p;
  p.nucleus.shear_modulus = 7.0;
  EXPECT_EQ(values_text(p), values_text({})) << "of no nucleus";
  p.nucleus.radius = 5.0;
  EXPECT_TRUE(has(values_text(p), "nucleus.radius = \"5 um\"\n"));
  EXPECT_TRUE(has(values_text(p), "nucleus.shear_modulus = \"7000 Pa\"\n"));
}

TEST(NucleusParameters, StandTogetherInTheirPlace) {
  const auto rows = schema();
  const auto first = std::ranges::find(rows, "nucleus", section_of);
  ASSERT_NE(first, rows.end());
  EXPECT_EQ(section_of(*(first - 1)), "contact.cells");
  EXPECT_EQ(section_of(*(first + 11)), "actomyosin");
}

TEST(NucleusParameters, AreRead) {
  const Parameters p = parse_parameters("[nucleus]\nradius = \"4 um\"\nshear_modulus = \"0.2 kPa\"\n"
                                        "stretch_stiffness = \"1 nN\"\nbending_stiffness = 0.1\n",
                                        "f.toml");
  EXPECT_EQ(p.nucleus.radius, 4.0);
  EXPECT_DOUBLE_EQ(p.nucleus.shear_modulus, 0.2);
  EXPECT_EQ(p.nucleus.stretch_stiffness, 1.0);
  EXPECT_EQ(p.nucleus.bending_stiffness, 0.1);
}

TEST(NucleusParameters, ThatAreWrongAreFaultsWithTheirPlace) {
  const std::string large = fault_of("[nucleus]\nradius = \"15 um\"\n");
  EXPECT_TRUE(has(large, "f.toml:2:")) << large;
  EXPECT_TRUE(has(large, "allowed is <= 14.5 um")) << large;
  EXPECT_TRUE(has(fault_of("[nucleus]\nradius = \"-1 um\"\n"), "f.toml:2:"));
  const std::string few = fault_of("[nucleus]\nradius = \"5 um\"\nparticles = 20\n");
  EXPECT_TRUE(has(few, "take 32 particles or more")) << few;
  EXPECT_EQ(faults_of("[nucleus]\nradius = \"5 um\"\nparticles = 32\n").size(), 0U);
  EXPECT_EQ(faults_of("[nucleus]\nparticles = 20\n").size(), 0U) << "there is none";
  EXPECT_TRUE(has(fault_of("[nucleus]\nradius = \"5 um\"\nrepulsion_range = \"15 um\"\n"), "no room"));
  EXPECT_TRUE(has(fault_of("[nucleus]\nshear_modulus = \"1 um\"\n"), "f.toml:2:"));
}

} // namespace nucleus_test

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
