#include "draw/cell_drawing.hpp"

#include "draw/cell_colours.hpp"
#include "draw/svg.hpp"
#include "draw/ticks.hpp"
#include "draw/tunnel.hpp"
#include "state/protrusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace matrigrate::draw {

namespace {

// Lightness tells them apart without colour: degraded matrix is lighter, the cell is darker than both, its front
// lighter than its rear.
constexpr std::string_view intact_colour = "#cbb994";
constexpr std::string_view degraded_colour = "#f8f6f1";
constexpr std::string_view obstacle_colour = "#3d4248";
constexpr std::string_view path_colour = "#1f2328";
constexpr std::string_view nucleus_colour = "#27406b";

constexpr std::size_t phases = std::variant_size_v<Phase>;
constexpr std::array<std::string_view, phases> phase_colours{"#f0a500", "#d55e00", "#8b1a6b", "#6e7781"};
constexpr std::array<std::string_view, phases> phase_names{"growing", "maturing", "contracting", "finishing"};
constexpr std::array<std::string_view, phases> phase_dashes{"", "", "", " stroke-dasharray=\"4 3\""};

/// Path data of a curve through points, or of a polygon.
std::string curve(const std::vector<Vec2>& points, const Panel& panel, bool closed) {
  std::string data;
  for (const Vec2& x : points) {
    const Vec2 a = panel.at(x);
    data += (data.empty() ? 'M' : 'L') + svg::point(a.x(), a.y());
  }
  return closed && !data.empty() ? data + 'Z' : data;
}

bool seen(const Vec2& a, const Panel& panel, double margin) {
  return a.x() > panel.left - margin && a.x() < panel.left + panel.side + margin && a.y() > panel.top - margin
         && a.y() < panel.top + panel.side + margin;
}

std::string disc(const observe::CellScene& scene, const Panel& panel) {
  const Vec2 centre = panel.at(Vec2::Zero());
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\"/>\n", svg::coordinate(centre.x()),
                     svg::coordinate(centre.y()), svg::coordinate(panel.scale() * (scene.radius + 0.5 * scene.spacing)),
                     intact_colour);
}

/// Particles of an obstacle as squares: short lines as wide as they are long. They overlap, so that they leave no gaps
/// where matrix is stretched.
std::string obstacles(const observe::CellScene& scene, const Panel& panel) {
  const double size = 1.25 * scene.spacing * panel.scale();
  const std::string stroke = fmt::format("h{:.2f}", size);
  std::string data;
  for (const Vec2& x : scene.obstacles) {
    const Vec2 a = panel.at(x);
    if (x.allFinite() && seen(a, panel, size)) data += 'M' + svg::point(a.x() - 0.5 * size, a.y()) + stroke;
  }
  if (data.empty()) return data;
  return fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\" d=\"{}\"/>\n", obstacle_colour, size,
                     data);
}

/// The disc, and what is degraded of it.
std::string matrix(const observe::CellScene& scene, const Panel& panel) {
  std::string data;
  for (const Curve& edge : degraded_edges(scene, panel.box)) data += curve(edge, panel, true);
  if (data.empty()) return disc(scene, panel);
  return disc(scene, panel) + fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", degraded_colour, data);
}

std::string area(const std::vector<Vec2>& polygon, const Panel& panel, std::string_view colour) {
  return fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", colour, curve(polygon, panel, true));
}

/// A line with a light edge, so that it is seen on any ground.
std::string edged(const std::string& data, std::string_view colour, double width, std::string_view dashes) {
  return fmt::format("<path fill=\"none\" stroke=\"#ffffff\" stroke-width=\"{}\" stroke-linejoin=\"round\" d=\"{}\"/>\n"
                     "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{} d=\"{}\"/>\n",
                     width + 1.6, data, colour, width, dashes, data);
}

std::string adhesion(const Vec2& tip, const Vec2& anchor, std::string_view colour) {
  return edged('M' + svg::point(tip.x(), tip.y()) + 'L' + svg::point(anchor.x(), anchor.y()), colour, 1.4, "")
         + fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"3.6\" fill=\"{}\" stroke=\"#ffffff\"/>\n",
                       svg::coordinate(anchor.x()), svg::coordinate(anchor.y()), colour);
}

std::string protrusion(const observe::DrawnProtrusion& drawn, const Panel& panel) {
  const std::string_view colour = phase_colours[drawn.phase];
  std::string out = edged(curve(drawn.contour, panel, false), colour, 2.8, phase_dashes[drawn.phase]);
  if (drawn.anchor) out += adhesion(panel.at(drawn.tip), panel.at(*drawn.anchor), colour);
  return out;
}

std::string path(const observe::DrawnCell& cell, const Panel& panel, std::string_view colour) {
  if (cell.path.empty()) return {};
  const Vec2 start = panel.at(cell.path.front());
  return edged(curve(cell.path, panel, false), colour, 1.6, "")
         + fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"3.2\" fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"1.6\"/>\n",
                       svg::coordinate(start.x()), svg::coordinate(start.y()), colour);
}

/// The number of a cell in its middle, dark on a light disc.
std::string number_of(const observe::DrawnCell& cell, std::size_t index, const Panel& panel) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& x : cell.outline) sum += x;
  const Vec2 middle = panel.at(sum / static_cast<double>(cell.outline.size()));
  constexpr double size = 13.0;
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"9\" fill=\"#ffffff\" fill-opacity=\"0.85\"/>\n",
                     svg::coordinate(middle.x()), svg::coordinate(middle.y()))
         + svg::text(middle.x(), middle.y() + 0.35 * size, std::to_string(index + 1),
                     {.size = size, .anchor = svg::Anchor::middle, .bold = true});
}

/// The drawn sign and the words of an entry of the legend.
struct Entry {
  std::string sign; ///< 30 x 14 pixels around (15, 0)
  std::string words;
};

/// A rectangle, front over rear.
std::string both_halves(const CellColours& colours) {
  return svg::rectangle(0.0, -7.0, 15.0, 14.0, colours.rear) + svg::rectangle(15.0, -7.0, 15.0, 14.0, colours.front);
}

/// One for each colour: "cell 1, 9".
std::vector<Entry> cell_entries(std::size_t cells) {
  std::vector<Entry> entries;
  if (cells < 2) {
    const CellColours colours = cell_colours(0, cells);
    return {{svg::rectangle(0.0, -7.0, 30.0, 14.0, colours.front), "front"},
            {svg::rectangle(0.0, -7.0, 30.0, 14.0, colours.rear), "rear"}};
  }
  for (std::size_t k = 0; k < std::min(cells, cell_colour_count); ++k) {
    std::string words = fmt::format("cell {}", k + 1);
    for (std::size_t j = k + cell_colour_count; j < cells && words.size() < 16; j += cell_colour_count)
      words += fmt::format(", {}", j + 1);
    entries.push_back({both_halves(cell_colours(k, cells)), words});
  }
  entries.back().words += cells > 3 * cell_colour_count ? ", ...; rear, front" : "; rear, front";
  return entries;
}

std::vector<Entry> legend_entries(const observe::CellScene& scene) {
  std::vector<Entry> entries;
  entries.push_back({svg::rectangle(0.0, -7.0, 30.0, 14.0, intact_colour), "intact matrix"});
  entries.push_back(
      {svg::rectangle(0.0, -7.0, 30.0, 14.0, degraded_colour) + svg::frame(0.0, -7.0, 30.0, 14.0), "degraded"});
  if (!scene.obstacles.empty()) entries.push_back({svg::rectangle(0.0, -7.0, 30.0, 14.0, obstacle_colour), "obstacle"});
  for (Entry& entry : cell_entries(scene.cells.size())) entries.push_back(std::move(entry));
  if (std::ranges::any_of(scene.cells, [](const observe::DrawnCell& cell) { return !cell.nucleus.empty(); }))
    entries.push_back({svg::rectangle(0.0, -7.0, 30.0, 14.0, nucleus_colour), "nucleus"});
  for (std::size_t k = 0; k < phases; ++k)
    entries.push_back({edged("M1 0h28", phase_colours[k], 4.0, phase_dashes[k]), std::string(phase_names[k])});
  entries.push_back({adhesion({3.0, 0.0}, {25.0, 0.0}, phase_colours[2]), "adhesion"});
  entries.push_back({edged("M4 0h25", path_colour, 1.6, "")
                         + fmt::format("<circle cx=\"4\" cy=\"0\" r=\"3.2\" fill=\"#ffffff\" stroke=\"{}\" "
                                       "stroke-width=\"1.6\"/>\n",
                                       path_colour),
                     "path of the centre"});
  return entries;
}

} // namespace

std::string drawing(const observe::CellScene& scene, const Panel& panel) {
  // A nested svg element cuts off what lies outside, without an id.
  std::string out = fmt::format("<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{2}\" viewBox=\"{0} {1} {2} {2}\">\n",
                                svg::coordinate(panel.left), svg::coordinate(panel.top), svg::coordinate(panel.side));
  out += matrix(scene, panel) + obstacles(scene, panel);
  const std::size_t n = scene.cells.size();
  for (std::size_t k = 0; k < n; ++k) {
    const observe::DrawnCell& cell = scene.cells[k];
    const CellColours colours = cell_colours(k, n);
    if (!cell.outline.empty()) out += area(cell.outline, panel, colours.rear) + area(cell.front, panel, colours.front);
    if (!cell.nucleus.empty()) out += area(cell.nucleus, panel, nucleus_colour);
  }
  for (const observe::DrawnProtrusion& drawn : scene.protrusions) out += protrusion(drawn, panel);
  for (std::size_t k = 0; k < n; ++k) out += path(scene.cells[k], panel, n > 1 ? cell_colours(k, n).rear : path_colour);
  for (std::size_t k = 0; k < n && n > 1; ++k)
    if (!scene.cells[k].outline.empty()) out += number_of(scene.cells[k], k, panel);
  return out + "</svg>\n";
}

std::string scale_bar(double x, double y, double most, const Panel& panel) {
  const double longest = most / panel.scale();
  double length = round_step(0.4 * longest); // at most 2.5 times what is asked for
  if (length > longest) length = 0.4 * longest;
  return svg::rectangle(x, y, length * panel.scale(), 5.0, svg::dark)
         + svg::text(x + length * panel.scale() + 8.0, y + 8.5, fmt::format("{:.4g} µm", length), {});
}

CellLegend cell_legend(double width, const observe::CellScene& scene) {
  constexpr double sign_width = 30.0;
  constexpr double gap = 7.0;
  constexpr double entry_gap = 20.0;
  constexpr double row = 1.55 * svg::tick_size;
  CellLegend legend;
  double x = 0.0;
  double y = 0.0;
  for (const Entry& entry : legend_entries(scene)) {
    const double entry_width = sign_width + gap + svg::text_width(entry.words, svg::tick_size);
    if (x > 0.0 && x + entry_width > width) {
      x = 0.0;
      y += row;
    }
    legend.svg += fmt::format("<g transform=\"translate({})\">{}</g>\n", svg::point(x, y + 0.5 * row), entry.sign)
                  + svg::text(x + sign_width + gap, y + 0.5 * row + 0.35 * svg::tick_size, entry.words, {});
    x += entry_width + entry_gap;
  }
  legend.height = y + row;
  return legend;
}

} // namespace matrigrate::draw
