#include "draw/text_plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace matrigrate::draw {
namespace {

TEST(TextPlot, DrawsBothCurvesBetweenZeroAndTheLargestValue) {
  const TextPlot plot{.x_name = "F",
                      .x_unit = "nN",
                      .x_low = 0.0,
                      .x_high = 10.0,
                      .points = {0.0, 1.0, 2.0, std::nan(""), 4.0},
                      .comparison = {4.0, 4.0, 4.0, 4.0, 4.0},
                      .width = 5,
                      .height = 5};
  EXPECT_EQ(to_text(plot), "        4 |....*\n"
                           "          |\n"
                           "          |  *\n"
                           "          | *\n"
                           "        0 |*\n"
                           "           F = 0 10 nN\n");
}

TEST(TextPlot, IsDrawnOfNothing) {
  const TextPlot plot{.x_name = "t", .x_unit = "", .x_low = 0, .x_high = 1, .points = {0, 0}, .comparison = {0, 0}};
  EXPECT_NE(to_text(plot).find("        1 |\n"), std::string::npos);
}

} // namespace
} // namespace matrigrate::draw
