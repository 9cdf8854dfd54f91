#include "draw/figure_panel.hpp"

#include "base/time_text.hpp"
#include "draw/cell_drawing.hpp"
#include "draw/colour_bar.hpp"
#include "draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

namespace matrigrate::draw {

namespace {

constexpr double side = 300.0;          ///< of a picture [pixel]
constexpr double colour_bar_gap = 16.0; ///< between the pictures and the colour bar [pixel]

void check(std::span<const observe::CellScene> scenes, const FigureField* field) {
  if (scenes.empty()) throw std::invalid_argument("a figure of no moment");
  if (field == nullptr) return;
  const bool one_each = field->value.size() == scenes.size() && field->position.size() == scenes.size();
  const auto same_size = [](const auto& values, const auto& positions) { return values.size() == positions.size(); };
  if (!one_each || !std::ranges::equal(field->value, field->position, same_size))
    throw std::invalid_argument("a figure has values of other moments or particles than it has positions");
}

Axis axis_of(const FigureField& field, double height) {
  return {.low = field.low,
          .high = field.high,
          .begin = svg::margin + svg::text_height(1, svg::label_size) + height,
          .end = svg::margin + svg::text_height(1, svg::label_size),
          .ticks = linear_ticks(field.low, field.high, 7)};
}

/// The particles of a moment by colour, fluid first.
std::vector<ColouredParticles> coloured(const FigureField& field, std::size_t k, const Axis& axis) {
  std::vector<ColouredParticles> out{{std::string(fluid_colour()), {}}};
  for (int level = 0; level < colour_levels; ++level) out.push_back({level_colour(field.map, level), {}});
  for (std::size_t i = 0; i < field.value[k].size(); ++i)
    out[static_cast<std::size_t>(1 + colour_level(field.value[k][i], axis))].position.push_back(field.position[k][i]);
  return out;
}

} // namespace

std::string figure_panel(std::span<const observe::CellScene> scenes, const FigureField* field) {
  check(scenes, field);
  const std::size_t columns = scenes.size() <= 4 ? scenes.size() : scenes.size() <= 6 ? 3 : 4;
  const std::size_t rows = (scenes.size() + columns - 1) / columns;
  const double heading = svg::text_height(1, svg::label_size);
  const auto along = [&](std::size_t n) { return static_cast<double>(n) * (side + svg::margin) - svg::margin; };
  const double pictures = std::max(along(columns), 460.0); // where the legend has room
  const double height = along(rows) + static_cast<double>(rows - 1) * heading;
  const Axis axis = field == nullptr ? Axis{} : axis_of(*field, height);
  Panel panel{.box = surroundings(scenes, room_around_cell), .left = svg::margin, .top = 0.0, .side = side};
  std::string body;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    panel.left = svg::margin + static_cast<double>(k % columns) * (side + svg::margin);
    panel.top = svg::margin + heading + static_cast<double>(k / columns) * (side + svg::margin + heading);
    body += svg::text(panel.left, panel.top - 6.0, time_text(scenes[k].t), {.size = svg::label_size, .bold = true});
    body += field == nullptr ? drawing(scenes[k], panel, IntactMatrix::area)
                             : drawing(scenes[k], panel, coloured(*field, k, axis));
    body += svg::frame(panel.left, panel.top, side, side);
  }
  double width = pictures + 2.0 * svg::margin;
  if (field != nullptr) {
    const double left = svg::margin + along(columns) + colour_bar_gap;
    const double label = left + colour_bar_width + 9.0 + label_width(axis) + svg::label_size + 4.0;
    body += colour_bar(axis, field->map, left);
    body += svg::text(label, 0.5 * (axis.begin + axis.end), field->label,
                      {.size = svg::label_size, .anchor = svg::Anchor::middle, .upward = true});
    width = std::max(width, label + svg::margin);
  }
  const double bottom = svg::margin + heading + height;
  body += scale_bar(svg::margin, bottom + 8.0, 0.5 * side, panel);
  const CellLegend legend = cell_legend(width - 2.0 * svg::margin, scenes.front(),
                                        field == nullptr ? MatrixColours::degradation : MatrixColours::field);
  body += fmt::format("<g transform=\"translate({})\">\n{}</g>\n", svg::point(svg::margin, bottom + scale_bar_height),
                      legend.svg);
  return svg::document(width, bottom + scale_bar_height + legend.height + 0.5 * svg::margin, "The cell at chosen times",
                       body);
}

} // namespace matrigrate::draw
