#include "validation/case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

using namespace matrigrate;
using namespace matrigrate::validation;

class Validation : public testing::TestWithParam<Case> {};

TEST_P(Validation, Holds) {
  const Result result = run_case(GetParam(), default_parameters());
  EXPECT_FALSE(result.checks.empty());
  for (const Check& check : result.checks)
    EXPECT_TRUE(check.holds()) << check.quantity << ": " << check.measured << ", expected " << check.expected << " +- "
                               << check.tolerance;
  const bool is_row = std::set<std::string>{"fibres", "fibres-uniaxial", "disassembly"}.contains(GetParam().name);
  for (const Check& claim : result.claims) // Figs 2 and 4; what other cases say of the paper need not come out
    EXPECT_TRUE(!is_row || claim.holds()) << claim.quantity << ": " << claim.measured << " beside " << claim.expected;
  EXPECT_FALSE(result.table.rows.empty());
  ASSERT_FALSE(result.plots.empty());
  EXPECT_EQ(result.plots.front().name, GetParam().name);
  for (const report::Plot& plot : result.plots) {
    EXPECT_FALSE(plot.title.empty() || plot.caption.empty() || plot.x_label.empty() || plot.y_label.empty())
        << plot.name;
    EXPECT_FALSE(plot.series.empty()) << plot.name;
    for (const report::Series& series : plot.series) {
      EXPECT_EQ(series.x.size(), series.y.size()) << plot.name << ": " << series.label;
      EXPECT_FALSE(series.x.empty()) << plot.name << ": " << series.label;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Validation, testing::ValuesIn(cases()), [](const auto& parameter) {
  std::string name = parameter.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});
