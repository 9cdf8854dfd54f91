#include "draw/cell_picture.hpp"

#include "base/time_text.hpp"
#include "draw/cell_colours.hpp"
#include "unit/draw/markup.hpp"

#include "cell/geometry.hpp"
#include "state/initial.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

namespace matrigrate::draw {
namespace {

CortexState ring_of(std::vector<Vec2> points) {
  CortexState c;
  c.x = std::move(points);
  return c;
}

Parameters parameters(double radius) {
  Parameters p;
  p.ecm.radius = radius;
  return p;
}

/// A round cell with protrusions in the phases that have an adhesion, and one that grows.
State state(const Parameters& p) {
  State s;
  s.t = 5400.0;
  s.ecm = disc(p);
  s.cells.emplace_back().cortex = round_cortex(p.cell);
  s.cells[0].polarization = 0.25 * std::numbers::pi;
  const auto add = [&](std::uint32_t centre, Phase phase) {
    s.cells[0].protrusions.emplace_back();
    s.cells[0].protrusions.back().centre = centre;
    s.cells[0].protrusions.back().phase = std::move(phase);
  };
  add(20, Growing{Vec2::UnitX()});
  add(80, Maturing{Vec2::UnitX(), Vec2(-10, 25), 2});
  add(140, Contracting{Vec2(-30, -5), 0.5});
  return s;
}

TEST(CellScene, SortsTheMatrixIntoClasses) {
  const Parameters p = parameters(40.0);
  State s = state(p);
  s.ecm.f.assign(s.ecm.size(), 1.0);
  s.ecm.f[0] = 0.0;
  s.ecm.f[1] = 0.001;
  s.ecm.f[2] = 0.999;
  s.ecm.f[3] = 0.5;
  const observe::CellScene scene = observe::cell_scene(s, p, {});
  EXPECT_EQ(scene.matrix[0].size(), s.ecm.size() - 4);
  for (std::size_t c = 1; c < observe::matrix_classes; ++c) EXPECT_EQ(scene.matrix[c].size(), 1U) << c;
}

TEST(CellScene, CutsTheFrontHalfOff) {
  const Parameters p = parameters(40.0);
  State s = state(p);
  const observe::CellScene scene = observe::cell_scene(s, p, {});
  EXPECT_NEAR(area(ring_of(scene.cells[0].front)), 0.5 * area(s.cells[0].cortex), 0.01 * area(s.cells[0].cortex));
  const Vec2 ahead = centroid(ring_of(scene.cells[0].front));
  EXPECT_NEAR(std::atan2(ahead.y(), ahead.x()), 0.25 * std::numbers::pi, 0.02);
  s.cells[0].polarization.reset();
  EXPECT_EQ(observe::cell_scene(s, p, {}).cells[0].front.size(), s.cells[0].cortex.size())
      << "all of it before the first protrusion";
}

TEST(CellScene, TakesProtrusionsWithTheirAnchors) {
  const Parameters p = parameters(40.0);
  const observe::CellScene scene = observe::cell_scene(state(p), p, {});
  ASSERT_EQ(scene.protrusions.size(), 3U);
  EXPECT_EQ(scene.protrusions[0].contour.size(), 2U * static_cast<std::size_t>(p.protrusion.half_width) + 1U);
  EXPECT_FALSE(scene.protrusions[0].anchor);
  EXPECT_EQ(scene.protrusions[2].anchor, Vec2(-30, -5));
}

TEST(Surroundings, AreASquareWithinTheDisc) {
  const Parameters p = parameters(40.0);
  const std::vector<observe::CellScene> scenes{observe::cell_scene(state(p), p, {})};
  const observe::Box box = surroundings(scenes, 3.0);
  EXPECT_NEAR(box.size().x(), 45.0 + 6.0, 0.1); // from the anchor at -30 to the cell's edge at 15, and room
  EXPECT_NEAR(box.size().x(), box.size().y(), 1e-12);
  EXPECT_LE(box.low.x(), -33.0 + 0.1);
  const observe::Box all = surroundings(scenes, 300.0);
  EXPECT_NEAR((all.low - whole_disc(scenes[0]).low).norm(), 0.0, 1e-12);
}

TEST(CellPicture, IsWellFormedAndSmall) {
  const Parameters p = parameters(150.0);
  const observe::CellScene scene = observe::cell_scene(state(p), p, {{Vec2(0, 0), Vec2(1, 1)}});
  const std::string svg = cell_picture(scene, whole_disc(scene));
  EXPECT_LT(svg.size(), 1000000U);
  ASSERT_TRUE(parsed(svg));
  EXPECT_LT(occurrences(svg, "<path"), 60U) << "one path a class, not one a particle";
  EXPECT_EQ(occurrences(svg, ">1 h 30 min<"), 1U);
  EXPECT_EQ(occurrences(svg, " µm<"), 1U) << "scale bar";
  for (const char* word : {"intact matrix", "degraded", "front", "rear", "growing", "maturing", "contracting",
                           "finishing", "adhesion", "path of the centre"})
    EXPECT_EQ(occurrences(svg, std::string(">") + word + "<"), 1U) << word;
}

TEST(CellPicture, ShowsObstacles) {
  const Parameters p = parameters(40.0);
  State s = state(p);
  EXPECT_EQ(
      occurrences(cell_picture(observe::cell_scene(s, p, {}), whole_disc(observe::cell_scene(s, p, {}))), ">obstacle<"),
      0U);
  s.ecm.obstacle.assign(s.ecm.size(), 0);
  s.ecm.obstacle[s.ecm.size() / 2] = 1;
  const observe::CellScene scene = observe::cell_scene(s, p, {});
  EXPECT_EQ(scene.obstacles.size(), 1U);
  EXPECT_EQ(occurrences(cell_picture(scene, whole_disc(scene)), ">obstacle<"), 1U);
}

TEST(CellPicture, ShowsNuclei) {
  const Parameters p = parameters(40.0);
  State s = state(p);
  const auto signs = [&] {
    const observe::CellScene scene = observe::cell_scene(s, p, {});
    return occurrences(cell_picture(scene, whole_disc(scene)), "#27406b");
  };
  EXPECT_EQ(signs(), 0U);
  s.cells[0].nucleus.x = {{0, 0}, {4, 0}, {0, 4}};
  EXPECT_EQ(signs(), 2U) << "in the cell and in the legend";
  EXPECT_EQ(
      occurrences(cell_picture(observe::cell_scene(s, p, {}), whole_disc(observe::cell_scene(s, p, {}))), ">nucleus<"),
      1U);
}

TEST(CellPicture, DrawsDegradedMatrixWhereItIsSeen) {
  const Parameters p = parameters(150.0);
  const observe::CellScene scene = observe::cell_scene(state(p), p, {});
  const auto degraded = [&](const observe::Box& box) {
    return occurrences(cell_picture(scene, box), "<path fill=\"#f8f6f1\"");
  };
  EXPECT_EQ(degraded(whole_disc(scene)), 1U);
  EXPECT_EQ(degraded({Vec2(60, 60), Vec2(90, 90)}), 0U);
}

TEST(CellPicture, ShowsEveryCell) {
  const Parameters p = parameters(40.0);
  State s = state(p);
  const observe::CellScene one = observe::cell_scene(s, p, {});
  s.cells.push_back(s.cells[0]);
  for (Vec2& x : s.cells[1].cortex.x) x += Vec2(5.0, 0.0);
  const observe::CellScene both = observe::cell_scene(s, p, {{Vec2(0, 0), Vec2(1, 1)}, {Vec2(5, 0), Vec2(6, 1)}});
  ASSERT_EQ(both.cells.size(), 2U);
  EXPECT_EQ(both.protrusions.size(), 2 * one.protrusions.size());
  const auto drawn = [](const observe::CellScene& scene, std::string_view colour) {
    return occurrences(cell_picture(scene, whole_disc(scene)), "<path fill=\"" + std::string(colour) + "\"");
  };
  for (const std::string_view colour : {cell_colours(0, 1).rear, cell_colours(0, 1).front})
    EXPECT_EQ(drawn(one, colour), 1U) << colour;
  for (const std::size_t k : {0U, 1U})
    for (const std::string_view colour : {cell_colours(k, 2).rear, cell_colours(k, 2).front})
      EXPECT_EQ(drawn(both, colour), 1U) << colour;
  const std::string picture = cell_picture(both, whole_disc(both));
  ASSERT_TRUE(parsed(picture));
  for (const char* word : {"1", "2", "cell 1", "cell 2; rear, front"})
    EXPECT_EQ(occurrences(picture, std::string(">") + word + "<"), 1U) << word;
}

TEST(CellPicture, NumbersCellsWhoseColourRepeats) {
  const Parameters p = parameters(40.0);
  State s = state(p);
  s.cells[0].protrusions.clear();
  while (s.cells.size() < 20) s.cells.push_back(s.cells[0]);
  const observe::CellScene scene = observe::cell_scene(s, p, {});
  const std::string picture = cell_picture(scene, whole_disc(scene));
  for (const char* word : {"20", "cell 1, 9, 17", "cell 8, 16; rear, front"})
    EXPECT_EQ(occurrences(picture, std::string(">") + word + "<"), 1U) << word;
}

/// Times over the panels of a sheet of n scenes, an hour apart [h].
std::vector<int> panel_hours(std::size_t n) {
  const Parameters p = parameters(20.0);
  std::vector<observe::CellScene> scenes(n, observe::cell_scene(state(p), p, {}));
  for (std::size_t k = 0; k < n; ++k) scenes[k].t = 3600.0 * static_cast<double>(k);
  const std::string svg = contact_sheet(scenes);
  std::vector<int> hours;
  for (std::size_t k = 0; k < n; ++k)
    if (occurrences(svg, ">" + time_text(scenes[k].t) + "<") == 1) hours.push_back(static_cast<int>(k));
  return hours;
}

TEST(ContactSheet, HasPanelsAtRegularTimes) {
  EXPECT_EQ(panel_hours(13), (std::vector<int>{0, 2, 4, 6, 8, 10, 12}));
  EXPECT_EQ(panel_hours(12).size(), 12U);
  EXPECT_EQ(panel_hours(25), (std::vector<int>{0, 3, 6, 9, 12, 15, 18, 21, 24}));
  EXPECT_EQ(panel_hours(15), (std::vector<int>{0, 2, 4, 6, 8, 10, 12, 14}));
  EXPECT_EQ(panel_hours(14), (std::vector<int>{0, 2, 4, 6, 8, 10, 12, 13})) << "the end belongs to it";
  EXPECT_EQ(panel_hours(1), std::vector<int>{0});
}

/// Rows of the panels of a sheet, by the places of their times.
std::vector<std::ptrdiff_t> panels_in_rows(std::size_t n) {
  const Parameters p = parameters(20.0);
  std::vector<observe::CellScene> scenes(n, observe::cell_scene(state(p), p, {}));
  for (std::size_t k = 0; k < n; ++k) scenes[k].t = 3600.0 * static_cast<double>(k);
  const std::string svg = contact_sheet(scenes);
  std::vector<std::string> heights;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t text = svg.rfind("<text", svg.find(">" + time_text(scenes[k].t) + "<"));
    const std::size_t y = svg.find(" y=\"", text);
    heights.push_back(svg.substr(y, svg.find('"', y + 4) - y));
  }
  std::vector<std::ptrdiff_t> rows;
  for (std::size_t k = 0; k < n; ++k)
    if (k == 0 || heights[k] != heights[k - 1]) rows.push_back(std::ranges::count(heights, heights[k]));
  return rows;
}

TEST(ContactSheet, LeavesNoPanelAloneInARow) {
  EXPECT_EQ(panels_in_rows(4), (std::vector<std::ptrdiff_t>{2, 2}));
  EXPECT_EQ(panels_in_rows(5), (std::vector<std::ptrdiff_t>{3, 2}));
  EXPECT_EQ(panels_in_rows(7), (std::vector<std::ptrdiff_t>{4, 3}));
  EXPECT_EQ(panels_in_rows(10), (std::vector<std::ptrdiff_t>{4, 4, 2}));
}

TEST(ContactSheet, IsOneDocumentWithOneLegend) {
  const Parameters p = parameters(150.0);
  const observe::CellScene one = observe::cell_scene(state(p), p, {});
  std::vector<observe::CellScene> scenes(25, one);
  for (std::size_t k = 0; k < scenes.size(); ++k) scenes[k].t = 3600.0 * static_cast<double>(k);
  const std::string svg = contact_sheet(scenes);
  ASSERT_TRUE(parsed(svg));
  EXPECT_LT(svg.size(), 1000000U);
  EXPECT_EQ(occurrences(svg, "<svg "), 10U) << "the document and nine panels";
  EXPECT_EQ(occurrences(svg, ">0 s<"), 1U);
  EXPECT_EQ(occurrences(svg, ">24 h<"), 1U);
  EXPECT_EQ(occurrences(svg, ">finishing<"), 1U) << "one legend for all";
  EXPECT_TRUE(parsed(contact_sheet(std::span(scenes).first(1))));
  EXPECT_TRUE(parsed(contact_sheet({}))) << "an empty sheet is a sheet";
}

} // namespace
} // namespace matrigrate::draw
