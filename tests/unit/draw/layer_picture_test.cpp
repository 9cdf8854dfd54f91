#include "draw/layer_picture.hpp"

#include "observe/fields.hpp"
#include "state/initial.hpp"
#include "unit/draw/markup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace matrigrate::draw {
namespace {

constexpr const char* grey = "#b8b8b8"; // of particles without a value

State pulled(const Parameters& p) {
  State s;
  s.ecm = disc(p);
  s.cells.emplace_back().cortex = round_cortex(p.cell);
  s.t = 1800.0;
  for (Vec2& x : s.ecm.x) x.x() *= 1.04;
  return s;
}

/// Number of particles that are drawn in each colour: a dot is a move and "h0".
std::map<std::string, std::size_t> dot_counts(const std::string& drawing) {
  std::map<std::string, std::size_t> of_colour;
  const auto pieces = parsed(drawing);
  if (!pieces) return of_colour;
  for (const Piece& piece : *pieces) {
    const auto path = piece.attributes.find("d");
    if (piece.name != "path" || path == piece.attributes.end()) continue;
    if (const std::size_t n = occurrences(path->second, "h0"); n > 0) of_colour[piece.attributes.at("stroke")] += n;
  }
  return of_colour;
}

std::size_t total(const std::map<std::string, std::size_t>& dots) {
  std::size_t sum = 0;
  for (const auto& [colour, n] : dots) sum += n;
  return sum;
}

std::size_t without_value(const std::vector<double>& values) {
  return static_cast<std::size_t>(std::ranges::count_if(values, [](double v) { return !std::isfinite(v); }));
}

TEST(LayerPicture, ShowsDisplacementsWithArrowsAndTheCell) {
  Parameters p;
  p.ecm.radius = 40.0;
  const State s = pulled(p);
  const std::string drawing = displacement_picture(s, p);
  EXPECT_TRUE(parsed(drawing));
  EXPECT_EQ(occurrences(drawing, "displacement (µm)"), 1U);
  EXPECT_GE(occurrences(drawing, "30 min"), 1U);
  EXPECT_EQ(occurrences(drawing, "nan"), 0U);
  const auto drawn = dot_counts(drawing);
  EXPECT_EQ(total(drawn), s.ecm.size());
  const std::size_t fluid = without_value(displacement_field(s.ecm));
  EXPECT_GT(fluid, 100U); // the cell's hole
  EXPECT_EQ(drawn.at(grey), fluid);
  EXPECT_GT(drawn.size(), 15U); // displacements grow from the centre: many steps of the colour map
}

TEST(LayerPicture, OfAMatrixAtRestHasOneColourAndNoArrows) {
  Parameters p;
  p.ecm.radius = 40.0;
  State at_rest;
  at_rest.ecm = disc(p);
  const std::string drawing = displacement_picture(at_rest, p);
  EXPECT_EQ(occurrences(drawing, "nan"), 0U);
  const auto drawn = dot_counts(drawing);
  EXPECT_EQ(total(drawn), at_rest.ecm.size());
  EXPECT_EQ(drawn.size(), 2U);                                          // solid without displacement, and fluid
  EXPECT_LT(drawing.size(), displacement_picture(pulled(p), p).size()); // no arrows, no cell
}

TEST(LayerPicture, ShowsTheStressOfTheFibres) {
  Parameters p;
  p.ecm.radius = 40.0;
  p.fibres.arrangement = FibreArrangement::isotropic;
  State s = pulled(p);
  for (std::size_t i = 0; i < s.ecm.size(); ++i) // stretched on the right only
    if (s.ecm.X[i].x() < 0.0) s.ecm.x[i] = s.ecm.X[i];
  const FibreNetwork network(s.ecm, p.ecm, p.fibres, Reference(s.ecm, p.ecm));
  const std::string drawing = fibre_stress_picture(s, p, network);
  EXPECT_TRUE(parsed(drawing));
  EXPECT_EQ(occurrences(drawing, "von Mises stress (Pa)"), 1U);
  const auto drawn = dot_counts(drawing);
  EXPECT_EQ(total(drawn), s.ecm.size());
  EXPECT_EQ(drawn.at(grey), without_value(fibre_stress_field(s.ecm, p.fibres, network)));
  EXPECT_GE(drawn.size(), 4U); // grey, slack on the left, taut on the right, and between
}

} // namespace
} // namespace matrigrate::draw
