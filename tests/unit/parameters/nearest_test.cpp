#include "parameters/nearest.hpp"

#include "parameters/schema.hpp"

#include <gtest/gtest.h>

namespace matrigrate {
namespace {

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
