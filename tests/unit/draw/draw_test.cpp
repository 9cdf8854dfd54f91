#include "draw/particle_picture.hpp"
#include "draw/text_plot.hpp"
#include "unit/draw/markup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

namespace matrigrate::draw {
namespace {

/// Perceived lightness L* of CIELAB, 0 black to 100 white.
double lightness(const std::string& colour) {
  const auto linear = [&](std::size_t at) {
    const double c = std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double luminance = 0.2126 * linear(1) + 0.7152 * linear(3) + 0.0722 * linear(5);
  return luminance > 0.008856 ? 116.0 * std::cbrt(luminance) - 16.0 : 903.3 * luminance;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ParticlePicture lattice(int columns, int rows) {
  ParticlePicture picture;
  picture.title = "Lattice";
  picture.value_label = "x [um]";
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      picture.position.emplace_back(1.7 * i, 1.7 * j);
      picture.value.push_back(1.7 * i);
    }
  return picture;
}

/// A group of dots of one colour.
struct Dots {
  std::string colour, data;
};

std::vector<Dots> dots(const std::string& svg) {
  std::vector<Dots> found;
  const auto pieces = parsed(svg);
  for (const Piece& piece : pieces.value_or(std::vector<Piece>{}))
    if (piece.name == "path" && piece.attributes.at("d").ends_with("h0"))
      found.push_back({piece.attributes.at("stroke"), piece.attributes.at("d")});
  return found;
}

/// The texts of a picture, of that size of the font.
std::vector<std::string> texts(const std::string& svg, const std::string& size) {
  std::vector<std::string> found;
  const auto pieces = parsed(svg).value_or(std::vector<Piece>{});
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
    if (pieces[i].name == "text" && pieces[i].attributes.at("font-size") == size) found.push_back(pieces[i + 1].text);
  return found;
}

/// The labels of the colour bar and of the scale bar, which is the last.
std::vector<std::string> labels(const ParticlePicture& picture) { return texts(to_svg(picture), "16"); }

TEST(ParticlePicture, HasColoursThatGetLighterEvenly) {
  const auto groups = dots(to_svg(lattice(40, 10)));
  ASSERT_EQ(groups.size(), 33U);
  const double whole = lightness(groups.back().colour) - lightness(groups.front().colour);
  EXPECT_GT(whole, 60.0);
  for (std::size_t i = 2; i < groups.size(); i += 2) { // steps of one level are rounded
    const double rise = 16.0 * (lightness(groups[i].colour) - lightness(groups[i - 2].colour)) / whole;
    EXPECT_GT(rise, 0.4) << i;
    EXPECT_LT(rise, 1.6) << i;
  }
}

TEST(ParticlePicture, ColoursOneValueInANeighbourhoodOfIt) {
  for (const double value : {0.0, 5.0, -1e-9, 1e140}) {
    ParticlePicture picture = lattice(1, 1);
    picture.value = {value};
    const auto groups = dots(to_svg(picture));
    ASSERT_EQ(groups.size(), 1U);
    EXPECT_EQ(groups[0].colour, "#23908c") << "the middle";
    EXPECT_GE(labels(picture).size(), 3U);
  }
}

TEST(ParticlePicture, DrawsEachParticleOnceGroupedByColour) {
  const auto groups = dots(to_svg(lattice(40, 10)));
  std::size_t particles = 0;
  std::set<std::string> colours;
  for (const Dots& group : groups) {
    particles += occurrences(group.data, "M");
    colours.insert(group.colour);
  }
  EXPECT_EQ(particles, 400U);
  EXPECT_EQ(groups.size(), 33U);
  EXPECT_EQ(colours.size(), groups.size());
  EXPECT_EQ(groups.front().colour.front(), '#');
}

TEST(ParticlePicture, LeavesNoGapsInALattice) {
  ParticlePicture picture = lattice(40, 10);
  picture.particle_size = 1.7;
  const std::string svg = to_svg(picture);
  double width = 0, x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  const std::size_t group = svg.find("stroke-linecap=\"square\" stroke-width=\"");
  ASSERT_NE(group, std::string::npos) << "squares, not dots";
  ASSERT_EQ(std::sscanf(svg.c_str() + group, "stroke-linecap=\"square\" stroke-width=\"%lf\"", &width), 1);
  const std::string column = dots(svg).front().data; // neighbours along y
  ASSERT_EQ(std::sscanf(column.c_str(), "M%lf %lfh0M%lf %lfh0", &x0, &y0, &x1, &y1), 4);
  EXPECT_GT(width, 1.02 * std::hypot(x1 - x0, y1 - y0));
}

TEST(ParticlePicture, StaysSmallForAWholeMatrix) {
  const std::string svg = to_svg(lattice(134, 135));
  ASSERT_TRUE(parsed(svg));
  EXPECT_LT(svg.size(), 700'000U);
}

TEST(ParticlePicture, BothDirectionsHaveOneScale) {
  ParticlePicture picture;
  picture.position = {{0, 0}, {50, 0}, {0, 10}};
  picture.value = {1, 1, 1};
  const auto groups = dots(to_svg(picture));
  ASSERT_EQ(groups.size(), 1U);
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0;
  ASSERT_EQ(std::sscanf(groups[0].data.c_str(), "M%lf %lfh0M%lf %lfh0M%lf %lfh0", &x0, &y0, &x1, &y1, &x2, &y2), 6);
  EXPECT_NEAR((x1 - x0) / 50.0, (y0 - y2) / 10.0, 0.02);
  EXPECT_GT(x1, x0);
  EXPECT_GT(y0, y2) << "y points up";
}

TEST(ParticlePicture, MissingValuesAreGreyAndMissingPlacesLeftOut) {
  ParticlePicture picture = lattice(3, 1);
  picture.value[0] = nan;
  picture.position[2].x() = nan;
  const auto groups = dots(to_svg(picture));
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].colour, "#b8b8b8");
  EXPECT_EQ(occurrences(groups[0].data, "M"), 1U);
  const std::string svg = to_svg(picture);
  double usual = 0.0, larger = 0.0;
  ASSERT_EQ(std::sscanf(svg.c_str() + svg.find("square\" stroke-width="), "square\" stroke-width=\"%lf\"", &usual), 1);
  ASSERT_EQ(std::sscanf(svg.c_str() + svg.find("h0\" stroke-width="), "h0\" stroke-width=\"%lf\"", &larger), 1);
  EXPECT_GT(larger, 1.5 * usual) << "fluid that has drifted apart leaves no specks";
  EXPECT_EQ(occurrences(groups[1].data, "M"), 1U);
}

TEST(ParticlePicture, ValuesBeyondTheBarGetTheColourOfItsEnd) {
  ParticlePicture picture = lattice(4, 1);
  picture.value = {-100.0, 0.001, 0.999, 100.0};
  picture.value_min = 0.0;
  picture.value_max = 1.0;
  const auto groups = dots(to_svg(picture));
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(occurrences(groups[0].data, "M"), 2U);
}

TEST(ParticlePicture, HasAScaleBarAndALabelledColourBar) {
  const std::string svg = to_svg(lattice(60, 30));
  EXPECT_EQ(occurrences(svg, ">20 µm<"), 1U);
  EXPECT_EQ(occurrences(svg, ">x [um]<"), 1U);
  EXPECT_EQ(occurrences(svg, ">100<"), 1U);
  EXPECT_EQ(occurrences(svg, " id="), 0U);
}

TEST(ParticlePicture, DrawsAnythingWellFormed) {
  for (const ParticlePicture& picture : {ParticlePicture{}, lattice(1, 1), lattice(1, 200), lattice(200, 1)}) {
    const std::string svg = to_svg(picture);
    EXPECT_TRUE(parsed(svg));
    EXPECT_EQ(occurrences(svg, "nan") + occurrences(svg, "inf"), 0U);
  }
  EXPECT_EQ(occurrences(to_svg(ParticlePicture{}), "no particles to draw"), 1U);
}

TEST(ParticlePicture, RefusesWhatDoesNotFitTogether) {
  ParticlePicture picture = lattice(3, 1);
  EXPECT_THROW(to_svg(picture, 100), std::invalid_argument);
  picture.value.pop_back();
  EXPECT_THROW(to_svg(picture), std::invalid_argument);
  picture = lattice(3, 1);
  picture.particle_size = 0.0;
  EXPECT_THROW(to_svg(picture), std::invalid_argument);
  picture = lattice(3, 1);
  picture.value_min = 2.0;
  picture.value_max = 1.0;
  EXPECT_THROW(to_svg(picture), std::invalid_argument);
}

TEST(ParticlePicture, EscapesMarkupAndForbiddenCharacters) {
  ParticlePicture picture = lattice(3, 1);
  picture.title = "a<b&\"c\">'d'";
  EXPECT_EQ(texts(to_svg(picture), "18"), (std::vector<std::string>{"a&lt;b&amp;&quot;c&quot;&gt;&#39;d&#39;"}));
  picture.title = std::string("x\x01y\x7fz\0w caf\u00e9", 13);
  EXPECT_EQ(texts(to_svg(picture), "18"), (std::vector<std::string>{"x y z w caf\u00e9"}));
  const std::string evil = "</text><script>\"'&\x02";
  picture.title = picture.value_label = evil;
  const auto pieces = parsed(to_svg(picture));
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->front().name, "svg");
  for (const Piece& piece : *pieces) EXPECT_NE(piece.name, "script");
}

TEST(ParticlePicture, RoundsCoordinatesToATenthOfAPixel) {
  for (const Dots& group : dots(to_svg(lattice(7, 7)))) {
    for (std::size_t at = group.data.find('.'); at != std::string::npos; at = group.data.find('.', at + 1)) {
      EXPECT_NE(group.data[at + 1], '0');
      EXPECT_EQ(std::string("M h").find(group.data[at + 2]) == std::string::npos, false) << group.data;
    }
    EXPECT_EQ(occurrences(group.data, "-0"), 0U);
  }
}

TEST(ParticlePicture, WrapsTextAtSpaces) {
  ParticlePicture picture = lattice(3, 1);
  const auto lines = [&](const std::string& title) {
    picture.title = title;
    return texts(to_svg(picture), "18");
  };
  EXPECT_TRUE(lines("").empty());
  EXPECT_EQ(lines("one  two "), (std::vector<std::string>{"one two"}));
  const std::string half(28, 'a'), whole(80, 'b');
  EXPECT_EQ(lines(half + ' ' + half), (std::vector<std::string>{half + ' ' + half}));
  EXPECT_EQ(lines(half + ' ' + half + ' ' + half), (std::vector<std::string>{half + ' ' + half, half}));
  EXPECT_EQ(lines(whole), (std::vector<std::string>{whole}));
  std::string wide; // characters count, not bytes
  for (int i = 0; i < 28; ++i) wide += "\u00b5";
  EXPECT_EQ(lines(wide + ' ' + wide), (std::vector<std::string>{wide + ' ' + wide}));
}

TEST(Svg, TheReaderOfTheseTestsRefusesWhatIsNotWellFormed) {
  EXPECT_TRUE(parsed("<a b=\"1\"><c/>x &amp; y</a>\n"));
  for (const char* bad :
       {"<a>", "<a></b>", "<a b=\"1\" b=\"2\"/>", "<a>x & y</a>", "<a b=1/>", "<a/>text", "<a b=\"<\"/>"})
    EXPECT_FALSE(parsed(bad)) << bad;
}

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

using Labels = std::vector<std::string>;

/// The labels of a colour bar.
Labels ticks(double low, double high) {
  ParticlePicture picture = lattice(3, 1);
  picture.value_min = low;
  picture.value_max = high;
  Labels all = labels(picture);
  all.pop_back(); // that of the scale bar
  return all;
}

TEST(Ticks, OfTheScaleBarAreOneTwoFive) {
  for (const auto& [size, label] : std::map<int, std::string>{{3, "1"}, {6, "2"}, {12, "5"}, {30, "10"}, {60, "20"}})
    EXPECT_EQ(labels(lattice(size, size)).back(), label + " \u00b5m");
}

TEST(Ticks, CarryEqualDigits) {
  EXPECT_EQ(ticks(0.0, 1.0), (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(ticks(-12.0, 31.0), (Labels{"\u221210", "0", "10", "20", "30"}));
  EXPECT_EQ(ticks(-0.3, 0.3), (Labels{"\u22120.3", "\u22120.2", "\u22120.1", "0.0", "0.1", "0.2", "0.3"}))
      << "no negative zero";
  EXPECT_EQ(ticks(999.99, 1000.01), (Labels{"999.990", "999.995", "1000.000", "1000.005", "1000.010"}));
}

TEST(Ticks, VeryLargeAndVerySmallNumbersTakeAPowerOfTen) {
  EXPECT_EQ(ticks(0.0, 4e-7), (Labels{"0", "1e\u22127", "2e\u22127", "3e\u22127", "4e\u22127"}));
  EXPECT_EQ(ticks(0.0, 2e6), (Labels{"0", "0.5e6", "1.0e6", "1.5e6", "2.0e6"}));
}

TEST(Ticks, StayFewForAnyRange) {
  for (const double scale : {1e-140, 1e-9, 1.0, 3.7, 1e9, 1e140})
    for (const double low : {-1.0, -0.31, 0.0, 0.77})
      for (const double span : {0.0123, 1.0, 7.3}) {
        const Labels found = ticks(scale * low, scale * (low + span));
        EXPECT_GE(found.size(), 2U) << scale << ' ' << low << ' ' << span;
        EXPECT_LE(found.size(), 8U) << scale << ' ' << low << ' ' << span;
        EXPECT_EQ(std::set<std::string>(found.begin(), found.end()).size(), found.size());
      }
}

} // namespace
} // namespace matrigrate::draw
