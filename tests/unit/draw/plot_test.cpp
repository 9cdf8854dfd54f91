#include "draw/plot.hpp"

#include "draw/axis.hpp"
#include "draw/legend.hpp"
#include "unit/draw/markup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <limits>
#include <locale>
#include <regex>
#include <stdexcept>
#include <utility>

namespace matrigrate::draw {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

Plot two_lines() {
  return {"Relaxation",
          "time [s]",
          "stress [Pa]",
          false,
          false,
          {{"measured", {0, 1, 2}, {0, 1, 4}, Mark::points, -1}, {"theory", {0, 2}, {0, 4}, Mark::dashed, -1}}};
}

/// Path data of the curves, which are the only paths with these attributes outside of the legend.
std::vector<std::string> curves(const std::string& svg) {
  const auto pieces = parsed(svg);
  std::vector<std::string> data;
  bool in_legend = false;
  for (const Piece& piece : pieces.value_or(std::vector<Piece>{})) {
    if (piece.name == "g") in_legend = true;
    if (piece.name == "rect" && piece.attributes.contains("stroke"))
      in_legend = false; // the frame comes before the curves
    if (!in_legend && piece.name == "path" && !piece.attributes.contains("stroke-width"))
      data.push_back(piece.attributes.at("d"));
    if (!in_legend && piece.name == "path" && piece.attributes.contains("stroke-linejoin"))
      data.push_back(piece.attributes.at("d"));
  }
  return data;
}

TEST(Axis, PutsItsEndsAtItsPixels) {
  Axis axis{.low = 10.0, .high = 1000.0, .log = false, .begin = 100.0, .end = 0.0, .ticks = {}};
  EXPECT_DOUBLE_EQ(axis.at(10.0), 100.0);
  EXPECT_DOUBLE_EQ(axis.at(1000.0), 0.0);
  EXPECT_DOUBLE_EQ(axis.at(505.0), 50.0);
  axis.log = true;
  EXPECT_DOUBLE_EQ(axis.at(100.0), 50.0);
}

TEST(Axis, LeavesRoomAroundTheValues) {
  const std::vector<double> values{2.0, 4.0};
  const Axis axis = fitted_axis(values, false, 0.1, 5);
  EXPECT_DOUBLE_EQ(axis.low, 1.8);
  EXPECT_DOUBLE_EQ(axis.high, 4.2);
}

TEST(Axis, GivesOneValueANeighbourhood) {
  for (const double value : {0.0, 1.0, -250.0, 1e-9, 1e140}) {
    const Axis axis = fitted_axis(std::vector<double>{value}, false, 0.0, 5);
    EXPECT_LT(axis.low, value);
    EXPECT_GT(axis.high, value);
    EXPECT_GE(axis.ticks.size(), 2U) << value;
  }
  const Axis axis = fitted_axis(std::vector<double>{5.0, 5.0}, true, 0.0, 5);
  EXPECT_LT(axis.low, 5.0);
  EXPECT_GT(axis.high, 5.0);
}

TEST(Plot, ShowsTitleLabelsAndLegend) {
  const std::string svg = to_svg(two_lines());
  ASSERT_TRUE(parsed(svg));
  for (const char* text : {">Relaxation<", ">time [s]<", ">stress [Pa]<", ">measured<", ">theory<"})
    EXPECT_EQ(occurrences(svg, text), 1U) << text;
  EXPECT_EQ(occurrences(svg, "no data"), 0U);
  EXPECT_EQ(occurrences(svg, " id="), 0U) << "ids would collide in a page";
}

TEST(Plot, PutsDataWhereTheAxesSay) {
  Plot plot{"",    "",    "",
            false, false, {{"", {0, 10}, {0, 100}, Mark::line, 0}, {"", {0, 5, 10}, {0, 50, 100}, Mark::line, 1}}};
  const auto data = curves(to_svg(plot));
  ASSERT_EQ(data.size(), 2U);
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0, a0 = 0, b0 = 0, a = 0, b = 0, a1 = 0, b1 = 0;
  ASSERT_EQ(std::sscanf(data[0].c_str(), "M%lf %lfL%lf %lf", &x0, &y0, &x1, &y1), 4);
  ASSERT_EQ(std::sscanf(data[1].c_str(), "M%lf %lfL%lf %lfL%lf %lf", &a0, &b0, &a, &b, &a1, &b1), 6);
  EXPECT_NEAR(a, 0.5 * (x0 + x1), 0.1);
  EXPECT_NEAR(b, 0.5 * (y0 + y1), 0.1);
  EXPECT_GT(y0, y1) << "larger values are higher up";
  EXPECT_LT(x0, x1);
}

TEST(Plot, BreaksLinesAtMissingValues) {
  Plot plot{"", "", "", false, false, {{"", {0, 1, 2, 3, 4, 5}, {0, 1, not_known, 3, not_known, 5}, Mark::line, 0}}};
  const auto data = curves(to_svg(plot));
  ASSERT_EQ(data.size(), 1U);
  EXPECT_EQ(occurrences(data[0], "M"), 3U);
  EXPECT_EQ(occurrences(data[0], "L"), 1U);
  EXPECT_EQ(occurrences(data[0], "h0.1"), 2U) << "lone points are still seen";
}

TEST(Plot, LeavesOutWhatALogAxisCannotShow) {
  Plot plot{"", "", "", true, true, {{"", {-1, 0, 1, 10, 100}, {1, 1, 1, 0, 100}, Mark::points, 0}}};
  const auto data = curves(to_svg(plot));
  ASSERT_EQ(data.size(), 1U);
  EXPECT_EQ(occurrences(data[0], "M"), 2U);
}

TEST(Plot, SaysThatThereIsNothingToDraw) {
  EXPECT_EQ(occurrences(to_svg(Plot{}), "no data to draw"), 1U);
  Plot plot = two_lines();
  plot.log_y = true;
  plot.series = {{"all negative", {1, 2}, {-1, -2}, Mark::line, 0}};
  EXPECT_EQ(occurrences(to_svg(plot), "no data to draw"), 1U);
}

TEST(Plot, SkipsPointsThatFallOnOnePixel) {
  Series s{"", {}, {}, Mark::line, 0};
  for (int i = 0; i < 100'000; ++i) {
    s.x.push_back(i);
    s.y.push_back(i);
  }
  EXPECT_LT(to_svg(Plot{"", "", "", false, false, {s}}).size(), 100'000U);
}

TEST(Plot, SurvivesExtremeValues) {
  const double inf = std::numeric_limits<double>::infinity();
  const double max = std::numeric_limits<double>::max();
  for (const bool log : {false, true}) {
    Plot plot{"", "", "", log, log, {{"", {1e-320, 1.0, inf, max}, {1.0, 1.0, 2.0, -max}, Mark::line, 0}}};
    const std::string svg = to_svg(plot);
    EXPECT_TRUE(parsed(svg));
    EXPECT_EQ(occurrences(svg, "nan"), 0U);
    EXPECT_EQ(occurrences(svg, "inf"), 0U);
  }
}

TEST(Plot, RefusesUnequalLengthsAndTinyDrawings) {
  Plot plot = two_lines();
  EXPECT_THROW(to_svg(plot, 100, 440), std::invalid_argument);
  plot.series[0].y.pop_back();
  EXPECT_THROW(to_svg(plot), std::invalid_argument);
}

TEST(Plot, GrowsRatherThanSqueezeTheCurves) {
  Plot plot = two_lines();
  const auto height = [](const Plot& p) { return std::stod(parsed(to_svg(p))->front().attributes.at("height")); };
  EXPECT_DOUBLE_EQ(height(plot), 440.0);
  for (int i = 0; i < 40; ++i)
    plot.series.push_back({"one of very many series " + std::to_string(i), {0}, {0}, Mark::line, -1});
  EXPECT_GT(height(plot), 700.0);
}

/// A locale that writes 1.234,5.
struct Comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Plot, SameBytesInEveryLocale) {
  Plot plot = two_lines();
  plot.series[0].x = {0.0, 1234.5, 20'000.25};
  const std::string before = to_svg(plot);
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new Comma));
  EXPECT_EQ(to_svg(plot), before);
  std::locale::global(old);
  const std::string old_c = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) {
    std::setlocale(LC_ALL, name); // stays as it is where this one is not installed
    EXPECT_EQ(to_svg(plot), before) << name;
  }
  std::setlocale(LC_ALL, old_c.c_str());
}

TEST(EqualAxes, DrawACircleAsACircle) {
  Series circle{.mark = Mark::points};
  for (int k = 0; k < 60; ++k) {
    circle.x.push_back(30.0 + 7.0 * std::cos(0.1047 * k));
    circle.y.push_back(-5.0 + 7.0 * std::sin(0.1047 * k));
  }
  Plot plot{.title = "a circle", .series = {circle}, .equal_axes = true};
  for (const auto& [width, height] : {std::pair{640, 440}, std::pair{300, 900}, std::pair{1200, 300}}) {
    const std::string drawing = to_svg(plot, width, height);
    double x_low = 1e9, x_high = -1e9, y_low = 1e9, y_high = -1e9;
    const std::regex dot_place("M([0-9.]+)[ ,]([0-9.]+)");
    const std::string dots = drawing.substr(drawing.rfind("<path"));
    for (auto m = std::sregex_iterator(dots.begin(), dots.end(), dot_place); m != std::sregex_iterator(); ++m) {
      const double x = std::stod((*m)[1]);
      const double y = std::stod((*m)[2]);
      x_low = std::min(x_low, x);
      x_high = std::max(x_high, x);
      y_low = std::min(y_low, y);
      y_high = std::max(y_high, y);
    }
    EXPECT_NEAR(x_high - x_low, y_high - y_low, 0.02 * (x_high - x_low)) << width << " x " << height;
    EXPECT_GT(x_high - x_low, 60.0);
  }
  plot.log_x = true;
  EXPECT_THROW(to_svg(plot), std::invalid_argument);
}

TEST(EqualAxes, StandAPathThatDoesNotMove) {
  const Plot plot{.title = "a point", .series = {Series{.x = {3.0, 3.0}, .y = {1.0, 1.0}}}, .equal_axes = true};
  EXPECT_EQ(occurrences(to_svg(plot), "nan"), 0U);
  EXPECT_EQ(occurrences(to_svg({.title = "nothing", .equal_axes = true}), "nan"), 0U);
}

TEST(Legend, WrapsInsteadOfRunningOutOfTheDrawing) {
  const std::vector<Series> series(6, Series{"a label of some length", {}, {}, Mark::line, -1});
  const Legend narrow = legend(series, 300.0);
  const Legend wide = legend(series, 3000.0);
  EXPECT_DOUBLE_EQ(narrow.height, 6.0 * wide.height);
  EXPECT_EQ(occurrences(narrow.svg, "<text"), 6U);
}

TEST(Legend, SkipsSeriesWithoutALabel) { EXPECT_EQ(legend({Series{"", {1}, {1}, Mark::line, -1}}, 300.0).height, 0.0); }

TEST(Legend, AutomaticColoursDoNotCountFixedOnes) {
  EXPECT_EQ(series_colours({Series{"", {}, {}, Mark::line, -1}, Series{"", {}, {}, Mark::line, 5},
                            Series{"", {}, {}, Mark::line, -1}}),
            (std::vector<int>{0, 5, 1}));
}

} // namespace
} // namespace matrigrate::draw
