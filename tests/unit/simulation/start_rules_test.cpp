#include "simulation/start.hpp"

#include "parameters/presets.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"

#include <gtest/gtest.h>

#include <ctime>
#include <regex>

namespace matrigrate {
namespace {

/// The faults of a text called "f.toml"; empty if it is good.
std::string faults_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_parameters(text, "f.toml", overrides, start_rules());
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return {};
}

/// The value that a message says to take.
std::string advised(const std::string& message) {
  std::smatch found;
  return std::regex_search(message, found, std::regex("take ([0-9.e-]+) s or less")) ? found[1].str() : "none";
}

TEST(StartRules, DefaultsFulfilThemAndTheirKeysExist) {
  for (const Rule& rule : start_rules()) {
    EXPECT_EQ(rule.broken(Parameters{}), "") << rule.name;
    for (const Preset& preset : presets()) EXPECT_EQ(rule.broken(parameters_of(preset)), "") << preset.name;
    for (const std::string_view key : rule.keys) EXPECT_NE(find_row(key), nullptr) << key;
  }
}

TEST(StartRules, TooLongAStepIsRefusedWithOneThatWorks) {
  for (const std::string& with :
       {std::string(), std::string("run.integrator = \"adaptive\"\necm.youngs_modulus = \"1 MPa\"\n"),
        std::string("ecm.youngs_modulus = 1500\n"),
        std::string("fibres.arrangement = \"isotropic\"\nfibres.stiffness = \"50 kPa\"\n")}) {
    const std::string fault = faults_of("run.time_step = 40\n" + with);
    EXPECT_TRUE(fault.starts_with("f.toml:1:17: run.time_step: a step of 40 s is longer than")) << fault;
    EXPECT_EQ(faults_of("run.time_step = " + advised(fault) + "\n" + with), "") << fault;
  }
}

TEST(StartRules, AreNotTriedOnALatticeThatIsRefusedAnyway) {
  const std::clock_t start = std::clock();
  for (const char* spacing : {"", "ecm.particle_spacing = 1\n"}) {
    const std::string fault = faults_of(std::string("ecm.radius = 60\necm.smoothing_length = 150\n") + spacing);
    EXPECT_NE(fault.find("smoothing length over particle spacing is"), std::string::npos) << fault;
    EXPECT_EQ(fault.find("a step of"), std::string::npos) << fault;
  }
  EXPECT_LT(std::clock() - start, 2 * CLOCKS_PER_SEC) << "one look at 70,000 neighbours takes 17 s";
}

TEST(StartRules, TheAdaptiveIntegratorHalvesStepsThatAreTooLong) {
  EXPECT_EQ(faults_of("run.time_step = 40\nrun.integrator = \"adaptive\"\n"), "");
  EXPECT_EQ(faults_of("run.integrator = \"adaptive\"\necm.youngs_modulus = \"5 kPa\"\n"), "");
}

TEST(StartRules, StiffFibresShortenTheStepAndAreNamed) {
  const std::string stiff = "fibres.arrangement = \"isotropic\"\nfibres.stiffness = \"1 MPa\"\n";
  EXPECT_TRUE(faults_of(stiff).starts_with("f.toml:2:20: fibres.stiffness: a step of 0.4 s is longer than"))
      << faults_of(stiff);
  EXPECT_TRUE(faults_of(stiff, {"run.time_step=0.41"}).starts_with("--set: run.time_step: ")) << "what was typed last";
}

TEST(StartRules, FibresWithoutBondsAreRefused) {
  const std::string fibres = "fibres.arrangement = \"uniaxial\"\nfibres.direction_deg = 13\nfibres.half_angle_deg = ";
  EXPECT_EQ(faults_of(fibres + "5\n"),
            "f.toml:2:24: fibres.direction_deg: no bond of the square lattice lies within fibres.half_angle_deg = 5 of "
            "fibres.direction_deg = 13, so there would be no fibres; the nearest bonds lie at 0, 26.57, 45, 153.4, "
            "63.43, 135, 116.6, 90 degrees");
  EXPECT_EQ(faults_of(fibres + "13.1\n"), "");
}

} // namespace
} // namespace matrigrate
