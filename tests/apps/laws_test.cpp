#include "program.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace matrigrate {
namespace {

using json = nlohmann::json;

/// Scenarios with laws of their own.
class LawsOfScenarios : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("cell.toml", "[run]\nduration = \"0.025 h\"\nintegrator = \"adaptive\"\n[ecm]\nradius = \"50 um\"\n"
                       "[protrusion]\ninitiation_rate = \"0.01 1/s\"\ngrowth_time = \"20 s\"\n");
  }
  json record(const std::string& run) const { return json::parse(text_of(folder / run / "run.json")); }
};

TEST_F(LawsOfScenarios, StandInTheRecordAndTheReportAndTheIdentity) {
  ASSERT_EQ(run("run cell.toml -o plain --quiet").code, 0);
  const Ended ended = run("run cell.toml -o stalled --quiet --set 'laws.growth_force=max(0, 1 - l/l_s)' --set "
                          "'laws.constants=l_s = 5 um'");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(record("plain").at("laws"), json::object());
  EXPECT_EQ(record("stalled").at("laws"),
            (json{{"laws.growth_force", "max(0, 1 - l/l_s)"}, {"laws.constants", "l_s = 5 um"}}));
  EXPECT_NE(record("stalled").at("configuration_hash"), record("plain").at("configuration_hash"));
  EXPECT_NE(record("stalled").at("trajectory_hash"), record("plain").at("trajectory_hash"));
  EXPECT_EQ(json::parse(page_data("plain/report.html")).at("laws"), json::array());
  const json shown = json::parse(page_data("stalled/report.html")).at("laws");
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(shown[0].at("name"), "laws.growth_force");
  EXPECT_EQ(shown[0].at("text"), "max(0, 1 - l/l_s)");
  EXPECT_EQ(shown[0].at("constants"), "l_s = 5 um");
  const json& curve = shown[0].at("curves").at(0);
  EXPECT_EQ(curve.at("over"), "l");
  EXPECT_EQ(curve.at("at"), "A = 1");
  EXPECT_EQ(curve.at("changed").at(0), 1.0) << curve;
  EXPECT_EQ(curve.at("changed").back(), 0.0) << curve;
  EXPECT_EQ(curve.at("usual").at(0), curve.at("usual").back()) << "Eq. 10 does not depend on the length";
  ASSERT_EQ(run("run stalled/scenario.resolved.toml -o again --quiet").code, 0);
  EXPECT_EQ(record("again").at("trajectory_hash"), record("stalled").at("trajectory_hash"));
  ASSERT_EQ(run("resume stalled --at '60 s' --hours 0.025 --seed 1 -o branch --quiet").code, 0);
  EXPECT_EQ(record("branch").at("trajectory_hash"), record("stalled").at("trajectory_hash")) << "after a break";
}

TEST_F(LawsOfScenarios, InOtherWordsAreTheSameRun) {
  const auto with = [](const std::string& law, const std::string& constants) {
    return "--quiet --set run.duration='0.002 h' --set 'laws.growth_force=" + law
           + "' --set 'laws.constants=" + constants + "'";
  };
  ASSERT_EQ(run("run cell.toml -o one " + with("max(0, 1 - l/l_s)*n", "l_s = 5 um, n = 1")).code, 0);
  const Ended again = run("run cell.toml -o one " + with("max(0,1-l / l_s) * n", "n=1.0,l_s = 0.005 mm"));
  EXPECT_EQ(again.code, 0) << again.out << again.err;
  ASSERT_EQ(run("run cell.toml -o two " + with("max(0,1-l / l_s) * n", "n=1.0,l_s = 0.005 mm")).code, 0);
  for (const char* key : {"configuration_hash", "laws", "trajectory_hash"})
    EXPECT_EQ(record("one").at(key), record("two").at(key)) << key;
  EXPECT_EQ(record("two").at("laws"),
            (json{{"laws.growth_force", "max(0, 1 - l/l_s)*n"}, {"laws.constants", "l_s = 5 um, n = 1"}}));
  EXPECT_EQ(json::parse(run("diff one two --json").out).at("parameters"), json::array());
  const Ended other = run("run cell.toml -o one " + with("0.5", ""));
  EXPECT_EQ(other.code, 5);
  EXPECT_TRUE(contains(other.err, "laws.constants: l_s = 5 um, n = 1 there, none here")) << other.err;
}

// Constants whose names came to be those of arguments after 0.3.0.
TEST_F(LawsOfScenarios, OfTheEarlierVersionAreTheSameRun) {
  const auto ended = [&](const std::string& into, const std::string& x, const std::string& speed) {
    return run("run cell.toml -o " + into
               + " --quiet --set run.duration='0.002 h' --set 'laws.growth_force=max(0, 1 - l/" + x + ")*" + speed
               + "' --set 'laws.constants=" + speed + " = 0.8, " + x + " = 25 um'");
  };
  const Ended told = ended("old", "x", "speed");
  ASSERT_EQ(told.code, 0) << told.err;
  EXPECT_EQ(record("old").at("configuration_hash"), "fff3f9f97da015ea") << "as 0.3.0 had it";
  ASSERT_EQ(ended("renamed", "x_0", "s_0").code, 0);
  EXPECT_EQ(record("old").at("trajectory_hash"), record("renamed").at("trajectory_hash"));
  const Ended checked = run("check old/scenario.resolved.toml");
  EXPECT_EQ(checked.code, 0);
  EXPECT_TRUE(
      contains(checked.out + checked.err, "laws.growth_force names x, your constant, which is also an argument"))
      << checked.out << checked.err;
}

TEST_F(LawsOfScenarios, ABiasOfZeroAllAroundIsNoneAndIsTold) {
  ASSERT_EQ(run("run cell.toml -o unbiased --quiet").code, 0);
  const std::string bias = " --set laws.initiation_bias=0";
  const Ended checked = run("check cell.toml" + bias);
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_TRUE(contains(checked.out, "laws.initiation_bias is 0 along the whole cortex at the start")) << checked.out;
  const Ended ended = run("run cell.toml -o biased" + bias);
  EXPECT_TRUE(contains(ended.out, "laws.initiation_bias was 0 along the whole cortex in ")) << ended.out;
  EXPECT_EQ(record("biased").at("trajectory_hash"), record("unbiased").at("trajectory_hash"));
  EXPECT_GT(record("biased").at("steps_without_bias"), 0);
  EXPECT_EQ(record("unbiased").at("steps_without_bias"), 0);
}

TEST_F(LawsOfScenarios, AreDrawnBesideThoseOfThePaper) {
  EXPECT_FALSE(contains(run("explain cell.toml").out, "by default"));
  const Ended ended = run("explain cell.toml --set 'laws.polarization_rate=r_pol*min(1, 0.5/angle)'");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(contains(ended.out, "laws.polarization_rate = \"r_pol*min(1, 0.5/angle)\"\n")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "   0.0011 |***")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "angle = 0 ")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "\nchecked, on a grid, over angle from 0 to 3.14159 rad\n")) << ended.out;
  const std::string two = run("explain cell.toml --set 'laws.disassembly_rate=1e-3*F*t'").out;
  const std::size_t second = two.find("\nat F = 0.3 nN, f_mat = 0.5:\n");
  EXPECT_LT(two.find("\nat f_mat = 0.5, t = 600 s:\n"), second) << two;
  EXPECT_LT(two.find(" F = 0 "), second) << "a curve over each argument: " << two;
  EXPECT_NE(two.find(" t = 0 ", second), std::string::npos) << two;
  EXPECT_TRUE(contains(two, "over F from 0 to 10 nN, f_mat from 0.01 to 1, t from 0 to 100000 s\n")) << two;
  const json found = json::parse(run("explain cell.toml --json --set 'laws.polarization_rate=2*r_pol'").out);
  EXPECT_EQ(found.at("law_ranges").at("laws.polarization_rate").at("angle").at("unit"), "rad");
  EXPECT_EQ(found.at("laws"), (json{{"laws.polarization_rate", "2*r_pol"}}));
}

TEST_F(LawsOfScenarios, AreRefusedBeforeAnythingIsWritten) {
  const std::size_t before = entries();
  for (const char* formula : {"1/angle", "r_pool", "-1", "r_pol = 2", "0,5", "((", "sqrt(1 - angle)"}) {
    const std::string set = std::string(" --set 'laws.polarization_rate=") + formula + "'";
    for (const char* verb : {"run cell.toml -o out --quiet", "check cell.toml", "explain cell.toml"}) {
      const Ended ended = run(verb + set);
      EXPECT_EQ(ended.code, 3) << verb << " " << formula << ended.out << ended.err;
      EXPECT_TRUE(contains(ended.out + ended.err, "laws.polarization_rate")) << ended.out << ended.err;
    }
  }
  EXPECT_EQ(entries(), before);
}

// Areas close to that of the round cell, between the points at which a law of three arguments is judged.
TEST_F(LawsOfScenarios, StopTheRunAtAValueThatOnlyTheRunMeets) {
  const Ended ended =
      run("run cell.toml -o out --quiet --set 'laws.growth_force=abs(A - 1) < 0.02 && A != 1 + 0*l*t ? 1000 : 1'");
  EXPECT_EQ(ended.code, 4) << ended.err;
  EXPECT_EQ(record("out").at("cause"), "law");
  EXPECT_TRUE(contains(record("out").at("reason"), "laws.growth_force is 1000")) << record("out");
}

TEST_F(LawsOfScenarios, AreSweptByAStudy) {
  write("laws.toml",
        "title = \"Laws\"\nscenario = \"cell.toml\"\nreplicates = 1\n[set]\nrun.duration = \"20 s\"\n[sweep]\n"
        "laws.curvature_factor = [\"exp(-0.5*((kappa - kappa_0)/kappa_w)^2)\", \"max(0, 1 - abs(kappa - "
        "kappa_0)/kappa_w)\"]\nlaws.constants = [\"\", \"n = 2\"]\n");
  const Ended ended = run("study run laws.toml --quiet");
  ASSERT_EQ(ended.code, 0) << ended.err << ended.out;
  const std::string table = text_of(folder / "laws-study/results.csv");
  EXPECT_TRUE(contains(table, "max(0, 1 - abs(kappa - kappa_0)/kappa_w)")) << table;
  const json axes = json::parse(page_data("laws-study/report.html")).at("axes");
  EXPECT_EQ(axes.at(0).at("values").at(1), "max(0, 1 - abs(kappa - kappa_0)/kappa_w)") << axes;
  EXPECT_EQ(axes.at(1).at("values"), (json{"none", "n = 2"})) << axes;
  write("bad.toml",
        "title = \"Laws\"\nscenario = \"cell.toml\"\nreplicates = 1\n[sweep]\nlaws.curvature_factor = [\"1\", "
        "\"kapa\", \"kappa\"]\n");
  const Ended bad = run("study run bad.toml");
  EXPECT_EQ(bad.code, 3);
  EXPECT_TRUE(contains(bad.err, "there is no kapa; did you mean kappa?")) << bad.err;
  EXPECT_FALSE(exists("bad-study"));
}

} // namespace
} // namespace matrigrate
