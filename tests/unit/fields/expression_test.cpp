#include "fields/expression.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace matrigrate::fields {
namespace {

constexpr std::array<std::string_view, 2> variables{"F", "f_mat"};
const std::vector<NamedNumber> constants{{"r_0", 0.2}, {"F_c", 0.05}};

std::string complaint(const std::string& text) {
  try {
    const Expression read(text, variables, constants);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(Expression, KnowsItsVariablesAndConstants) {
  const Expression e("r_0*exp(-F/(f_mat*F_c))", variables, constants);
  EXPECT_DOUBLE_EQ(e.at(std::array{0.1, 0.5}), 0.2 * std::exp(-0.1 / (0.5 * 0.05)));
  EXPECT_DOUBLE_EQ(e.at(std::array{0.0, 1.0}), 0.2);
}

TEST(Expression, TellsOnWhatItDepends) {
  const Expression e("r_0*f_mat", variables, constants);
  EXPECT_FALSE(e.uses(0));
  EXPECT_TRUE(e.uses(1));
}

TEST(Expression, MovesWithItsVariables) {
  Expression e("F + 1", variables, constants);
  const Expression other = std::move(e);
  EXPECT_EQ(other.at(std::array{2.0, 0.0}), 3.0);
}

TEST(Expression, NamesWhatItDoesNotKnow) {
  EXPECT_EQ(complaint("r_0*G"), "cannot be read as a formula in F and f_mat, at character 5: there is no G");
  try {
    const Expression e("r_O", variables, constants);
    FAIL();
  } catch (const UnknownName& error) {
    EXPECT_EQ(error.name, "r_O");
  }
  EXPECT_EQ(complaint("x"), "cannot be read as a formula in F and f_mat, at character 1: there is no x");
}

TEST(Expression, SaysWhichNamesAreTaken) {
  EXPECT_TRUE(in_every_formula("exp"));
  EXPECT_TRUE(in_every_formula("_pi"));
  EXPECT_FALSE(in_every_formula("F_c"));
}

} // namespace
} // namespace matrigrate::fields
