#include "parameters/changes.hpp"

#include "faults.hpp"
#include "parameters/assign.hpp"
#include "parameters/write.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace matrigrate {
namespace {

/// A drug at 2 h that is washed out at 4 h, in the wrong order.
constexpr std::string_view washout = "[actomyosin]\nforce = \"0.5 nN\"\n"
                                     "[[changes]]\nat = \"4 h\"\nactomyosin.force = \"0.5 nN\"\n"
                                     "[[changes]]\nat = \"120 min\"\nactomyosin.force = \"200 pN\"\n"
                                     "protrusion = { initiation_rate = \"3e-5 1/s\" }\nlaws.growth_force = 1\n";

Parameters read(std::string_view text, const std::vector<std::string>& overrides = {}) {
  return parse_parameters(text, "f.toml", overrides);
}

TEST(Changes, HoldFromTheirTimes) {
  const Parameters p = read(washout);
  const auto force = [&](double hours) { return in_force(p, 3600.0 * hours).actomyosin.force; };
  EXPECT_EQ(force(0.0), 0.5);
  EXPECT_EQ(force(1.9999), 0.5);
  EXPECT_EQ(force(2.0), 0.2);
  EXPECT_EQ(force(3.9999), 0.2);
  EXPECT_EQ(force(4.0), 0.5);
  EXPECT_EQ(in_force(p, 7200.0).protrusion.initiation_rate, 3e-5);
  EXPECT_EQ(in_force(p, 7200.0).laws.growth_force, "1");
  EXPECT_EQ(in_force(p, 7200.0).changes.size(), 1U) << "those to come";
  EXPECT_TRUE(same(in_force(in_force(p, 7200.0), 14400.0), in_force(p, 14400.0)));
}

TEST(Changes, AreSaidInWords) {
  std::vector<std::string> said;
  for (const ChangeWords& change : words_of_changes(read(washout))) said.push_back(to_text(change));
  EXPECT_EQ(said, (std::vector<std::string>{"at 2 h: actomyosin.force 0.5 -> 0.2 nN",
                                            "at 2 h: laws.growth_force \"n_prot > 0 && A > 1 ? 1/A : 1\" -> \"1\"",
                                            "at 2 h: protrusion.initiation_rate 6e-05 -> 3e-05 1/s",
                                            "at 4 h: actomyosin.force 0.2 -> 0.5 nN"}));
}

TEST(Changes, AreWrittenAndReadAgain) {
  const Parameters p = read(washout);
  EXPECT_EQ(to_toml(read(to_toml(p))), to_toml(p));
  EXPECT_TRUE(same(read(to_toml(p)), p));
  const Parameters by_option = read("actomyosin.force = \"0.5 nN\"", {"changes=" + changes_text(p)});
  EXPECT_TRUE(same(by_option, p));
  EXPECT_FALSE(same(p, read("actomyosin.force = \"0.5 nN\"")));
  EXPECT_TRUE(read(washout, {"changes=[]"}).changes.empty());
}

TEST(Changes, AreMeantWhateverTheirSpelling) {
  const std::string spelled = "[actomyosin]\nforce = 0.5\n[[changes]]\nat = 2\nactomyosin.force = 0.2\n"
                              "laws.growth_force = \" 1 \"\nprotrusion.initiation_rate = 3e-5\n"
                              "[[changes]]\nat = \"240 min\"\n[changes.actomyosin]\nforce = \"500 pN\"\n";
  EXPECT_EQ(values_text(read(spelled)), values_text(read(washout)));
  EXPECT_NE(values_text(read(washout, {"actomyosin.force=0.4 nN"})), values_text(read(washout)));
  EXPECT_EQ(values_text(read("changes = []")), values_text(Parameters{}));
  EXPECT_EQ(in_force(read(washout, {"actomyosin.force=0.4 nN"}), 7200.0).actomyosin.force, 0.2)
      << "an option sets what holds until then";
}

/// The fault of one change at 1 h of a run of 2 h.
std::string fault_of_change(const std::string& lines, const std::string& before = "") {
  return fault_of(before + "[run]\nduration = \"2 h\"\n[[changes]]\n" + lines);
}

TEST(Changes, SayWhatIsWrongWithTheirTimes) {
  const std::string line = "\ncell.dashpot = 0.003\n";
  EXPECT_EQ(fault_of_change("at = \"2 h\"" + line),
            "f.toml:4:6: changes[1].at: 2 h is not before the end of the run, run.duration, 2 h");
  EXPECT_EQ(fault_of_change("at = \"150 min\"" + line),
            "f.toml:4:6: changes[1].at: 2 h 30 min is not before the end of the run, run.duration, 2 h");
  for (const char* early : {"0 h", "-1 h"})
    EXPECT_EQ(fault_of_change(std::string("at = \"") + early + "\"" + line),
              std::string("f.toml:4:6: changes[1].at: \"") + early
                  + "\" is out of range; allowed is > 0 and <= 8760 h");
  EXPECT_EQ(
      fault_of_change("at = \"1.5 s\"" + line),
      "f.toml:4:6: changes[1].at: 1.5 s lies within a step: it is no multiple of run.time_step, 0.4 s; 1.2 s or 1.6 "
      "s is");
  EXPECT_EQ(fault_of_change("at = \"3 um\"" + line),
            "f.toml:4:6: changes[1].at: \"3 um\" is a length, but a time is expected; write it like \"3 h\"");
  EXPECT_EQ(fault_of_change("cell.dashpot = 0.003\n"),
            "f.toml:3:1: changes[1]: has no time; write it like at = \"3 h\"");
}

TEST(Changes, SayWhatIsWrongWithATimeBesideAValue) {
  EXPECT_EQ(faults_of("[run]\nduration = \"2 h\"\n[[changes]]\nat = \"3 h\"\ncell.radius = 9\n"),
            (std::vector<std::string>{
                "f.toml:4:6: changes[1].at: 3 h is not before the end of the run, run.duration, 2 h",
                "f.toml:5:15: changes[1].cell.radius: cannot change in the middle of a run: matrix and cells are made "
                "with it at the start"}));
}

TEST(Changes, SayWhatIsWrongWithTheirValues) {
  const std::string at = "at = \"1 h\"\n";
  EXPECT_EQ(fault_of_change(at),
            "f.toml:3:1: changes[1].at: nothing changes then; write below it a parameter with its new value, such as "
            "ecm.youngs_modulus = \"100 Pa\"");
  EXPECT_EQ(fault_of_change(at + "cell.dashpt = 3\n"),
            "f.toml:5:6: changes[1].cell.dashpt: there is no such parameter; did you mean cell.dashpot?");
  EXPECT_EQ(fault_of_change(at + "actomyosin.force = \"1 Pa\"\n"),
            "f.toml:5:20: changes[1].actomyosin.force: \"1 Pa\" is a stress, but a force is expected; write it like "
            "\"0.6 nN\"");
  EXPECT_EQ(fault_of_change(at + "actomyosin.force = \"-1 nN\"\n").find("out of range") == std::string::npos, false);
  EXPECT_EQ(fault_of_change(at + "cell.dashpot = 0.003\n[[changes]]\nat = \"60 min\"\ncell.dashpot = 0.004\n"),
            "f.toml:8:16: changes[2].cell.dashpot: has two values at one time; leave one of them out");
  EXPECT_EQ(
      fault_of("changes = 3"),
      "f.toml:1:11: changes: is a number, but an array of tables is expected; write [[changes]] and below it at = "
      "\"3 h\" and the parameters that change then");
  EXPECT_EQ(fault_of_change(at + "cells = []\n").find("changes[1].cells: cannot stand in a change")
                == std::string::npos,
            false);
}

TEST(Changes, SayWhyAParameterCannotChange) {
  const auto why = [](const std::string& line, const std::string& before = "") {
    const std::string fault = fault_of_change("at = \"1 h\"\n" + line, before);
    const std::string begin = "cannot change in the middle of a run: ";
    const std::size_t at = fault.find(begin);
    return at == std::string::npos ? fault : fault.substr(at + begin.size());
  };
  EXPECT_EQ(why("cell.radius = 10"), "matrix and cells are made with it at the start");
  EXPECT_EQ(why("ecm.fields.ligand = \"1\""), "fields are laid on the matrix at the start");
  EXPECT_EQ(why("ecm.youngs_modulus = 100", "ecm.fields.youngs_modulus = \"100 + 0.1*x\"\n"),
            "a field takes its place, laid on the matrix at the start");
  EXPECT_EQ(why("run.seed = 3"), "[run] holds for all of it; set it there, or branch the run");
  EXPECT_EQ(why("output.report = false"), "[output] holds for all of it; set it there, or branch the run");
}

TEST(Changes, KeepTheRulesOnSeveralParameters) {
  EXPECT_EQ(fault_of_change("at = \"1 h\"\nlaws.growth_force = \"1/q\"\n").substr(0, 68),
            "f.toml:5:21: changes[1].laws.growth_force: from 1 h on: cannot be re");
  const std::vector<std::string> faults =
      faults_of("[run]\nduration = \"2 h\"\n[[changes]]\nat = 3\ncell.dashpot = 0.003\n[[changes]]\nat = 1\n"
                "laws.growth_force = \"1/q\"\ncell.dashpt = 3\nrun.seed = 2\n");
  EXPECT_EQ(faults.size(), 4U) << "all at once";
}

TEST(Changes, DoNotJudgeTheValuesOfALawThatCannotBeRead) {
  const std::string law = "laws.growth_force = \"1/q\"\n";
  const std::string later = "[[changes]]\nat = \"1.5 h\"\nactomyosin.force = \"0.3 nN\"\n";
  EXPECT_EQ(faults_of("run.duration = \"2 h\"\n" + law + later).size(), 1U) << "from the start";
  EXPECT_EQ(faults_of("run.duration = \"2 h\"\n[[changes]]\nat = \"1 h\"\n" + law + later).size(), 1U)
      << "from a change on";
}

TEST(Changes, AreJudgedOneByOneForPython) {
  EXPECT_EQ(judged("changes.at", {"3 h", "a string"}).number, 3.0);
  EXPECT_EQ(judged("changes.cell.dashpot", {0.003, "a number"}).fault, "");
  EXPECT_EQ(judged("changes.cell.radius", {std::int64_t{3}, "a number"}).fault,
            "cannot change in the middle of a run: matrix and cells are made with it at the start");
}

} // namespace
} // namespace matrigrate
