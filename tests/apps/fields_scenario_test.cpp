#include "program.hpp"

#include <cstddef>

namespace matrigrate {
namespace {

/// Scenarios whose matrix differs from place to place.
class FieldsOfScenarios : public Program {
protected:
  void scenario(const std::string& fields) const {
    write("cell.toml", "[run]\nduration = \"0.05 h\"\nintegrator = \"adaptive\"\n[ecm]\nradius = \"60 um\"\n" + fields);
  }
  std::string hash(const std::string& run) const {
    const std::string record = text_of(folder / run / "run.json");
    const std::size_t at = record.find("\"trajectory_hash\": \"");
    return at == std::string::npos ? "" : record.substr(at + 20, 16);
  }
};

TEST_F(FieldsOfScenarios, AUniformFieldGivesTheBitsOfTheUniformMatrix) {
  scenario("");
  ASSERT_EQ(run("run cell.toml -o plain --quiet").code, 0);
  scenario("[ecm.fields]\nyoungs_modulus = \"200\"\nf_degr = \"1\"\n");
  ASSERT_EQ(run("run cell.toml -o field --quiet").code, 0);
  EXPECT_EQ(hash("field"), hash("plain"));
}

TEST_F(FieldsOfScenarios, AreTheSameFromTheResolvedScenarioAndAfterAResumption) {
  write("E.csv", "x_um,y_um,E_Pa\n-60,-60,100\n60,-60,300\n-60,60,100\n60,60,300\n");
  scenario("[ecm.fields]\nyoungs_modulus = \"E.csv\"\nf_degr = \"abs(y) < 5 ? 0 : 1\"\n");
  const Ended explained = run("explain cell.toml");
  EXPECT_TRUE(contains(explained.out, "field youngs_modulus")) << explained.out << explained.err;
  EXPECT_TRUE(contains(explained.out, "a grid of 2 x 2 nodes from (-60, -60) to (60, 60) um")) << explained.out;
  ASSERT_EQ(run("run cell.toml -o whole --quiet").code, 0);
  std::filesystem::create_directory(folder / "elsewhere");
  ASSERT_EQ(run("run whole/scenario.resolved.toml -o elsewhere/again --quiet").code, 0);
  EXPECT_EQ(hash("elsewhere/again"), hash("whole"));
  ASSERT_EQ(run("resume whole --at '60 s' --hours 0.05 --seed 1 -o branch --quiet").code, 0);
  EXPECT_EQ(hash("branch"), hash("whole")) << "a branch without a change";
  std::filesystem::rename(folder / "E.csv", folder / "away.csv");
  ASSERT_EQ(run("resume whole --hours 0.06 -o further --quiet").code, 0) << "its checkpoint holds the values";
  std::filesystem::rename(folder / "away.csv", folder / "E.csv");
  ASSERT_EQ(run("resume whole --hours 0.06 -o beside --quiet").code, 0);
  EXPECT_EQ(hash("further"), hash("beside"));
  for (const char* text :
       {"ecm.fields.youngs_modulus=300 + x", "ecm.fields.f_degr=x > 0 ? 1 : 0", "ecm.youngs_modulus=300 Pa"}) {
    const std::string change = text;
    const Ended refused = run("resume whole --at '60 s' -o other --set '" + change + "'");
    EXPECT_EQ(refused.code, 3) << change << refused.err;
    EXPECT_FALSE(exists("other"));
  }
  write("E.csv", "x_um,y_um,E_Pa\n-60,-60,100\n60,-60,300\n-60,60,100\n60,60,301\n");
  const Ended changed = run("run whole/scenario.resolved.toml -o changed --quiet");
  EXPECT_EQ(changed.code, 3);
  EXPECT_TRUE(contains(changed.err, "has changed: its fingerprint is")) << changed.err;
}

TEST_F(FieldsOfScenarios, FilesAreFoundInAFolderWithSpaces) {
  std::filesystem::create_directory(folder / "sp ace");
  write("sp ace/my E.csv", "x_um,y_um,E_Pa\n-60,-60,100\n60,-60,300\n-60,60,100\n60,60,300\n");
  write("sp ace/cell.toml", "[run]\nduration = \"0.02 h\"\nintegrator = \"adaptive\"\n[ecm]\nradius = \"60 um\"\n"
                            "[ecm.fields]\nyoungs_modulus = \"my E.csv\"\nligand = \"50 + x/2\"\n");
  const Ended explained = run("explain 'sp ace/cell.toml'");
  EXPECT_TRUE(contains(explained.out, " Pa   ecm.fields; a grid of 2 x 2 nodes")) << explained.out << explained.err;
  ASSERT_EQ(run("run 'sp ace/cell.toml' -o whole --quiet").code, 0);
  ASSERT_EQ(run("run whole/scenario.resolved.toml -o again --quiet").code, 0);
  EXPECT_EQ(hash("again"), hash("whole"));
}

TEST_F(FieldsOfScenarios, EveryFaultIsToldAtOnceWithItsPlaceAndNothingIsWritten) {
  scenario("[ecm.fields]\nyoungs_modulus = \"195 - 10*x\"\nf_degr = \"channel.png pixel=1 from=0 to=1\"\n"
           "[fibres]\narrangement = \"uniaxial\"\n[fibres.field]\ndirection_deg = \""
           + std::string(2000, '1') + "\"\n");
  const Ended ended = run("run cell.toml -o out");
  EXPECT_EQ(ended.code, 3);
  EXPECT_FALSE(exists("out"));
  EXPECT_EQ(run("explain cell.toml").code, 3);
  for (const char* part : {"cell.toml:7:", "cell.toml:8:", "cell.toml:12:", "ecm.fields.youngs_modulus: is -",
                           "channel.png", "allowed are 1000"})
    EXPECT_TRUE(contains(ended.err, part)) << part << "\n" << ended.err;
}

TEST_F(FieldsOfScenarios, DirectionsOfAPictureAreForFibresAlone) {
  const std::string picture = MATRIGRATE_SOURCE_DIR "/scenarios/collagen.png pixel=0.5 direction=4";
  scenario("[ecm.fields]\nyoungs_modulus = \"" + picture + "\"\nligand = \"" + picture + "\"\n");
  const Ended ended = run("check cell.toml");
  EXPECT_EQ(ended.code, 3);
  EXPECT_TRUE(contains(ended.err, "ecm.fields.youngs_modulus: direction= takes the direction of fibres")) << ended.err;
  EXPECT_TRUE(contains(ended.err, "ecm.fields.ligand: direction= takes the direction of fibres")) << ended.err;
  scenario("[fibres]\narrangement = \"uniaxial\"\nstiffness = \"10 kPa\"\n[fibres.field]\ndirection_deg = \"" + picture
           + "\"\n");
  EXPECT_EQ(run("check cell.toml").code, 0);
}

TEST_F(FieldsOfScenarios, AnObstacleBetweenParticlesIsToldOf) {
  const auto explained = [&](const std::string& radius2) {
    write("post.toml", "[ecm]\nradius = \"60 um\"\n[ecm.fields]\nyoungs_modulus = \"200 + x\"\nobstacle = "
                       "\"(x-41)^2 + (y-1)^2 < "
                           + radius2 + " ? 1 : 0\"\n");
    return run("explain post.toml").out;
  };
  EXPECT_TRUE(contains(explained("0.5"), "no matrix particle lies in an obstacle"));
  EXPECT_FALSE(contains(explained("9"), "no matrix particle lies in an obstacle"));
  EXPECT_TRUE(contains(explained("9"), "E by a field"));
}

TEST_F(FieldsOfScenarios, AComparisonOfThreeValuesIsRefusedByAllVerbs) {
  write("chained.toml", "[ecm]\nradius = \"60 um\"\n[ecm.fields]\nf_degr = \"-5 < y < 5 ? 0 : 1\"\n");
  for (const char* verb : {"check", "explain", "run", "validate patch --scenario"}) {
    const Ended ended = run(std::string(verb) + " chained.toml");
    EXPECT_EQ(ended.code, 3) << verb;
    EXPECT_TRUE(contains(ended.err, "compare twice: -5 < y && y < 5")) << verb << ended.err;
  }
}

TEST_F(FieldsOfScenarios, PresetsRun) {
  for (const char* preset : {"stiffness-gradient", "stiffness-step", "channel", "microtrack", "curved-fibres"}) {
    const std::string name(preset);
    ASSERT_EQ(run("new " + name + ".toml --preset " + name).code, 0);
    const Ended ended = run("run " + name + ".toml --hours 0.02 --quiet -o " + name);
    EXPECT_EQ(ended.code, 0) << name << ended.err;
  }
}

} // namespace
} // namespace matrigrate
