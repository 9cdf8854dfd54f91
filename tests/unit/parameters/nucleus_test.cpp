#include "faults.hpp"
#include "parameters/schema.hpp"
#include "parameters/write.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace matrigrate;

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
