#include "draw/particle_picture.hpp"
#include "unit/draw/markup.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <set>
#include <stdexcept>

namespace matrigrate::draw {
namespace {

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

} // namespace
} // namespace matrigrate::draw
