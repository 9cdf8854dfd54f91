#include "draw/cell_picture.hpp"

#include "base/time_text.hpp"
#include "draw/cell_drawing.hpp"
#include "draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace matrigrate::draw {

namespace {

/// Scale bar and legend below the panels. @return their SVG and where it ends [pixel]
CellLegend footer(double top, double width, const Panel& panel, const observe::CellScene& scene) {
  const CellLegend legend = cell_legend(width - 2.0 * svg::margin, scene);
  CellLegend out;
  out.svg = scale_bar(svg::margin, top + 8.0, 0.5 * panel.side, panel)
            + fmt::format("<g transform=\"translate({})\">\n{}</g>\n", svg::point(svg::margin, top + scale_bar_height),
                          legend.svg);
  out.height = top + scale_bar_height + legend.height + 0.5 * svg::margin;
  return out;
}

/// Indices of at most `most` of n at equal distances, from the first on; the last one among them, which alone may
/// follow sooner.
std::vector<std::size_t> chosen(std::size_t n, std::size_t most) {
  if (n == 0 || most == 0) return {};
  if (most == 1) return {n - 1};
  std::size_t step = std::max<std::size_t>(1, (n - 1 + most - 2) / (most - 1));
  for (std::size_t wider = step; 2 * ((n - 1) / wider + 1) >= most; ++wider) // one that meets the end, if there is any
    if ((n - 1) % wider == 0) {
      step = wider;
      break;
    }
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < n; i += step) indices.push_back(i);
  if (indices.back() != n - 1) indices.push_back(n - 1);
  return indices;
}

void check(int width) {
  if (width < 240) throw std::invalid_argument(fmt::format("a picture {} pixels wide is too small", width));
}

} // namespace

std::string cell_picture(const observe::CellScene& scene, const observe::Box& box, int width) {
  check(width);
  const double top = svg::margin + svg::text_height(1, svg::title_size);
  const Panel panel{.box = box, .left = svg::margin, .top = top, .side = width - 2.0 * svg::margin};
  const CellLegend below = footer(top + panel.side, width, panel, scene);
  const std::string title = time_text(scene.t);
  const std::string body =
      svg::text(svg::margin, svg::margin + svg::title_size - 4.0, title, {.size = svg::title_size, .bold = true})
      + drawing(scene, panel) + svg::frame(panel.left, panel.top, panel.side, panel.side) + below.svg;
  return svg::document(width, below.height, "Cell and matrix after " + title, body);
}

std::string contact_sheet(std::span<const observe::CellScene> scenes, std::size_t most, int width) {
  check(width);
  const std::vector<std::size_t> indices = chosen(scenes.size(), most);
  const std::size_t n = indices.size(); // no picture is alone in a row
  const auto columns = std::clamp<std::size_t>(n, 1, n == 4 ? 2 : n % 3 == 1 ? 4 : 3);
  const double gap = svg::margin;
  const double side =
      (width - 2.0 * svg::margin - static_cast<double>(columns - 1) * gap) / static_cast<double>(columns);
  const double heading = svg::text_height(1, svg::label_size);
  Panel panel{.box = surroundings(scenes, room_around_cell), .left = svg::margin, .top = 0.0, .side = side};
  std::string body;
  double bottom = svg::margin;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const observe::CellScene& scene = scenes[indices[k]];
    const std::size_t row = k / columns;
    panel.left = svg::margin + static_cast<double>(k - row * columns) * (side + gap);
    panel.top = svg::margin + static_cast<double>(row) * (side + gap + heading) + heading;
    body += svg::text(panel.left, panel.top - 6.0, time_text(scene.t), {.size = svg::label_size, .bold = true});
    body += drawing(scene, panel) + svg::frame(panel.left, panel.top, side, side);
    bottom = panel.top + side;
  }
  const CellLegend below = footer(bottom, width, panel, scenes.empty() ? observe::CellScene{} : scenes.front());
  return svg::document(width, below.height, "The cell over time", body + below.svg);
}

} // namespace matrigrate::draw
