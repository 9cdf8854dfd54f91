#include "draw/figure_panel.hpp"

#include "draw/cell_drawing.hpp"
#include "draw/frame_scene.hpp"
#include "unit/draw/markup.hpp"
#include "unit/observe/frames.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace matrigrate::draw {
namespace {

TEST(FrameScene, IsThatOfTheState) {
  const SmallRun run;
  const observe::Film film = run.film();
  const observe::CellScene made = frame_scene(film.head, film.frames[0], {{Vec2(1.0, 2.0)}});
  const observe::CellScene scene = observe::cell_scene(run.s, run.p, {{Vec2(1.0, 2.0)}});
  EXPECT_EQ(made.t, scene.t);
  EXPECT_EQ(made.radius, scene.radius);
  EXPECT_EQ(made.spacing, scene.spacing);
  ASSERT_EQ(made.cells.size(), 1U);
  const observe::DrawnCell& cell = made.cells.front();
  EXPECT_EQ(cell.path, scene.cells.front().path);
  constexpr double rounding = 1e-4; // positions of frames are of 32 bits, displacements of steps of 1/16384 um
  const auto near = [&](const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((a[i] - b[i]).norm(), rounding) << i;
  };
  for (std::size_t c = 0; c < observe::matrix_classes; ++c) near(made.matrix[c], scene.matrix[c]);
  near(cell.outline, scene.cells.front().outline);
  EXPECT_NEAR(static_cast<double>(cell.front.size()), 0.5 * static_cast<double>(cell.outline.size()), 1.0);
  ASSERT_EQ(made.protrusions.size(), scene.protrusions.size());
  for (std::size_t k = 0; k < made.protrusions.size(); ++k) {
    EXPECT_EQ(made.protrusions[k].phase, scene.protrusions[k].phase);
    EXPECT_EQ(made.protrusions[k].anchor.has_value(), scene.protrusions[k].anchor.has_value());
    EXPECT_LT((made.protrusions[k].tip - scene.protrusions[k].tip).norm(), rounding);
    near(made.protrusions[k].contour, scene.protrusions[k].contour);
  }
}

struct Moments {
  Moments() {
    const observe::Film film = SmallRun().film();
    for (const observe::Frame& frame : film.frames) {
      scenes.push_back(frame_scene(film.head, frame, {}));
      field.position.push_back(matrix_positions(film.head, frame));
      field.value.emplace_back(field.position.back().size(), 1.0);
      for (std::size_t i = 0; i < field.value.back().size(); ++i)
        if (field.position.back()[i].norm() < 5.0) field.value.back()[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  std::vector<observe::CellScene> scenes;
  FigureField field{
      .label = "pressure [Pa]", .map = ColourMap::diverging, .low = -2.0, .high = 2.0, .position = {}, .value = {}};
};

TEST(FigurePanel, HasAPictureForEachMomentAndOneColourBar) {
  const Moments m;
  const std::string svg = figure_panel(m.scenes, &m.field);
  ASSERT_TRUE(parsed(svg)) << svg.substr(0, 400);
  EXPECT_EQ(occurrences(svg, "viewBox"), 1 + m.scenes.size());
  EXPECT_EQ(occurrences(svg, ">5 min</text>"), 1U);
  EXPECT_EQ(occurrences(svg, ">10 min</text>"), 1U);
  EXPECT_EQ(occurrences(svg, "pressure [Pa]"), 1U);
  EXPECT_EQ(occurrences(svg, " um</text>"), 1U) << "one scale bar";
  EXPECT_EQ(occurrences(svg, "fluid matrix"), 1U);
  EXPECT_GT(occurrences(svg, fluid_colour()), m.scenes.size()) << "fluid in each picture, and in the legend";
  const std::string bare = figure_panel(m.scenes, nullptr);
  ASSERT_TRUE(parsed(bare));
  EXPECT_EQ(occurrences(bare, "pressure"), 0U);
  EXPECT_EQ(occurrences(bare, "matrix, solid to fluid"), 1U);
}

TEST(FigurePanel, RefusesWhatDoesNotFit) {
  Moments m;
  EXPECT_THROW(figure_panel({}, nullptr), std::invalid_argument);
  m.field.value[1].pop_back();
  EXPECT_THROW(figure_panel(m.scenes, &m.field), std::invalid_argument);
  m.field.value.pop_back();
  EXPECT_THROW(figure_panel(m.scenes, &m.field), std::invalid_argument);
}

} // namespace
} // namespace matrigrate::draw
