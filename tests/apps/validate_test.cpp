#include "program.hpp"

#include <nlohmann/json.hpp>

namespace matrigrate {
namespace {

using nlohmann::json;

TEST_F(Program, ValidateWritesCurvesAndReport) {
  const Ended ended = run("validate patch");
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_TRUE(contains(ended.out, "measured")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "1 of 1 case holds; report: validate-patch/report.html")) << ended.out;
  for (const char* file : {"patch.csv", "report.html", "scenario.resolved.toml"})
    EXPECT_TRUE(exists(std::string("validate-patch/") + file)) << file;
  EXPECT_EQ(run("check validate-patch/scenario.resolved.toml").code, 0);
  const json page = json::parse(page_data("validate-patch/report.html"));
  const json results = json::parse(text_of(folder / "validate-patch/results.json"));
  const json& statement = page.at("statements").at(0);
  EXPECT_EQ(statement.at("verdict"), "holds");
  EXPECT_EQ(statement.at("checks"), results.at("cases").at(0).at("checks"));
  EXPECT_EQ(statement.at("plots").at(0).at("name"), "patch");
  EXPECT_FALSE(statement.at("plots").at(0).at("series").at(0).at("x").empty());
}

TEST_F(Program, ValidateDrawsPicturesOfParticlesItself) {
  ASSERT_EQ(run("validate stretch --quiet").code, 0);
  const json statement = json::parse(page_data("validate-stretch/report.html")).at("statements").at(0);
  EXPECT_EQ(statement.at("pictures").at(0).at("svg"), text_of(folder / "validate-stretch/stretch-specimen.svg"));
  EXPECT_EQ(statement.at("plots").at(0).at("series").size(), 3U);
}

TEST_F(Program, ValidateSpeaksJson) {
  const Ended ended = run("validate patch --json -o here --set ecm.youngs_modulus=400");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json found = json::parse(ended.out);
  EXPECT_EQ(found.at("folder"), "here");
  EXPECT_TRUE(found.at("holds").get<bool>());
  EXPECT_FALSE(found.at("cases").at(0).at("checks").empty());
  EXPECT_TRUE(contains(text_of(folder / "here/scenario.resolved.toml"), "youngs_modulus = \"400 Pa\""));
}

TEST_F(Program, ValidateTakesAScenario) {
  write("s.toml", "[ecm]\nyoungs_modulus = \"50 Pa\"\n");
  ASSERT_EQ(run("validate patch --quiet --scenario s.toml").code, 0);
  EXPECT_TRUE(contains(text_of(folder / "validate-patch/scenario.resolved.toml"), "youngs_modulus = \"50 Pa\""));
}

TEST_F(Program, ValidateRefusesAFolderThatIsNotEmpty) {
  std::filesystem::create_directory(folder / "validate-patch");
  write("validate-patch/mine", "mine");
  const Ended ended = run("validate patch");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "--force")) << ended.err;
  EXPECT_FALSE(exists("validate-patch/report.html"));
  EXPECT_EQ(run("validate patch --force --quiet").code, 0);
  EXPECT_TRUE(exists("validate-patch/report.html"));
  EXPECT_EQ(text_of(folder / "validate-patch/mine"), "mine");
}

TEST_F(Program, ValidateWritesNothingOnABadConfiguration) {
  EXPECT_EQ(run("validate patch --set ecm.radius=1").code, 3);
  EXPECT_EQ(run("validate patch --scenario none.toml").code, 5);
  EXPECT_EQ(run("validate fibres-uniaxial --set 'laws.fibre_stiffness=1+sin(1e7*eps)'").code, 3);
  EXPECT_EQ(run("validate protrusion --set laws.growth_force=-1").code, 3);
  EXPECT_TRUE(contains(run("validate disassembly --set laws.disassembly_rate=1").err, "takes no other law"));
  EXPECT_EQ(entries(), 0u);
}

TEST_F(Program, ACaseThatDoesNotHoldIsWrittenAndIsAFailure) {
  // Solved to 10 % only, the layer cannot relax as the closed form does.
  const Ended ended = run("validate relaxation --set solver.tolerance=0.1");
  EXPECT_EQ(ended.code, 4);
  EXPECT_TRUE(contains(ended.out, "does not hold")) << ended.out;
  for (const char* file : {"relaxation.csv", "report.html"})
    EXPECT_TRUE(exists(std::string("validate-relaxation/") + file)) << file;
}

TEST_F(Program, ANumericalFailureEndsItsCaseOnly) {
  // A solver that may not iterate cannot balance a load, whatever the case.
  const Ended ended = run("validate point-force --set solver.max_iterations=1");
  EXPECT_EQ(ended.code, 4);
  EXPECT_TRUE(contains(ended.out, "stopped:")) << ended.out;
  EXPECT_FALSE(exists("validate-point-force/point-force.csv")) << "nothing half-written";
  const json statement = json::parse(page_data("validate-point-force/report.html")).at("statements").at(0);
  EXPECT_EQ(statement.at("verdict"), "does not hold");
  EXPECT_EQ(statement.at("details").at(0).at("name"), "Stopped");
}

} // namespace
} // namespace matrigrate
