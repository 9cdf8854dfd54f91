#include "study_report/box_plot.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace matrigrate::study {
namespace {

TEST(BoxPlot, DrawsEachSample) {
  const std::string svg = to_svg({{"f_mat", {"one", "none"}, {{1.0, 2.0, 3.0, 4.0}, {}}}}, "A <title>");
  EXPECT_NE(svg.find("one (n = 4)"), std::string::npos);
  EXPECT_NE(svg.find("none (n = 0)"), std::string::npos);
  EXPECT_NE(svg.find("A &lt;title&gt;"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_THROW(to_svg({{"f_mat", {"one"}, {}}}, ""), std::invalid_argument);
}

} // namespace
} // namespace matrigrate::study
