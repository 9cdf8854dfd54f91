#include "draw/legend.hpp"

#include "draw/colour.hpp"
#include "draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::draw {

namespace {

constexpr double key_width = 34.0; ///< the piece of line or the dot beside an entry [pixel]
constexpr double key_gap = 8.0;
constexpr double entry_gap = 24.0;

std::string key(Mark mark, int colour, double x, double y) {
  const std::string data = mark == Mark::points ? dot(x + 0.5 * key_width, y, colour)
                                                : fmt::format("M{}h{}", svg::point(x, y), svg::coordinate(key_width));
  return fmt::format("<path {} d=\"{}\"/>\n", line_style(mark, colour), data);
}

} // namespace

std::vector<int> series_colours(const std::vector<Series>& series) {
  std::vector<int> colours;
  colours.reserve(series.size());
  int next = 0;
  for (const Series& s : series) colours.push_back(s.colour >= 0 ? s.colour : next++);
  return colours;
}

std::string line_style(Mark mark, int colour) {
  const std::string_view c = palette(colour);
  if (mark == Mark::points) return fmt::format("fill=\"{}\"", c);
  return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2.5\" stroke-linejoin=\"round\" {}", c,
                     mark == Mark::dashed ? "stroke-dasharray=\"9 6\"" : "stroke-linecap=\"round\"");
}

std::string dot(double x, double y, int colour) {
  switch (colour % 4) {
  case 1:
    return fmt::format("M{}h8v8h-8z", svg::point(x - 4.0, y - 4.0)); // square
  case 2:
    return fmt::format("M{}l5 9h-10z", svg::point(x, y - 6.0)); // triangle
  case 3:
    return fmt::format("M{}l5.5 5.5l-5.5 5.5l-5.5 -5.5z", svg::point(x, y - 5.5)); // diamond
  default:
    return fmt::format("M{}a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0 -9 0z", svg::point(x - 4.5, y)); // disc
  }
}

Legend legend(const std::vector<Series>& series, double width) {
  const std::vector<int> colours = series_colours(series);
  const double row = svg::line_height * svg::tick_size;
  Legend result;
  double x = 0.0;
  double y = 0.0;
  double row_height = 0.0;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (series[i].label.empty()) continue;
    const auto lines = svg::wrapped(series[i].label, width - key_width - key_gap, svg::tick_size);
    double text_width = 0.0;
    for (const auto& l : lines) text_width = std::max(text_width, svg::text_width(l, svg::tick_size));
    const double entry_width = key_width + key_gap + text_width;
    if (x > 0.0 && x + entry_width > width) {
      x = 0.0;
      y += row_height;
      row_height = 0.0;
    }
    result.svg += key(series[i].mark, colours[i], x, y + 0.5 * row);
    result.svg += svg::text_lines(x + key_width + key_gap, y + 0.77 * row, lines, {});
    x += entry_width + entry_gap;
    row_height = std::max(row_height, svg::text_height(lines.size(), svg::tick_size));
  }
  result.height = y + row_height;
  return result;
}

} // namespace matrigrate::draw
