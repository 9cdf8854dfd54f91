#include "draw/plot.hpp"

#include "draw/axis.hpp"
#include "draw/legend.hpp"
#include "draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace matrigrate::draw {

namespace {

constexpr double tick_room = 26.0; ///< below the horizontal axis, for its numbers
constexpr double tick_gap = 8.0;   ///< between the vertical axis and its numbers

void check(const Plot& plot, int width, int height) {
  if (width < 240 || height < 200)
    throw std::invalid_argument(fmt::format("a plot of {} x {} pixels is too small", width, height));
  if (plot.equal_axes && (plot.log_x || plot.log_y)) throw std::invalid_argument("equal axes of a plot must be linear");
  for (const Series& s : plot.series)
    if (s.x.size() != s.y.size())
      throw std::invalid_argument(
          fmt::format("series '{}' of a plot has {} x and {} y", s.label, s.x.size(), s.y.size()));
}

bool drawn(const Plot& plot, const Series& s, std::size_t i) {
  return drawable(s.x[i], plot.log_x) && drawable(s.y[i], plot.log_y);
}

/// Coordinates of all points that are drawn.
std::vector<double> drawn_values(const Plot& plot, std::vector<double> Series::*coordinate) {
  std::vector<double> values;
  for (const Series& s : plot.series)
    for (std::size_t i = 0; i < s.x.size(); ++i)
      if (drawn(plot, s, i)) values.push_back((s.*coordinate)[i]);
  return values;
}

/// Widens the narrower extent by two values, so that the extents stand in the ratio `aspect`, x over y.
void match_extents(std::vector<double>& x, std::vector<double>& y, double aspect) {
  if (x.empty()) return;
  const auto [x_low, x_high] = std::ranges::minmax(x);
  const auto [y_low, y_high] = std::ranges::minmax(y);
  const double x_extent = std::max(x_high - x_low, aspect * (y_high - y_low));
  const double y_extent = x_extent / aspect;
  for (const double sign : {-0.5, 0.5}) {
    x.push_back(0.5 * (x_low + x_high) + sign * x_extent);
    y.push_back(0.5 * (y_low + y_high) + sign * y_extent);
  }
}

/// Takes the longer axis back until a unit is as long on both.
void match_scales(Axis& x, Axis& y) {
  const double scale = std::min((x.end - x.begin) / (x.high - x.low), (y.begin - y.end) / (y.high - y.low));
  x.end = x.begin + scale * (x.high - x.low);
  y.begin = y.end + scale * (y.high - y.low);
}

std::string line_path(const Plot& plot, const Series& s, const Axis& x, const Axis& y) {
  std::string path;
  std::string last;
  bool alone = false; // a lone point between two gaps is drawn as a dot of the line's width
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    if (!drawn(plot, s, i)) {
      if (alone) path += "h0.1";
      alone = false;
      last.clear();
      continue;
    }
    const std::string point = svg::point(x.at(s.x[i]), y.at(s.y[i]));
    if (point == last) continue;
    alone = last.empty();
    path += (alone ? 'M' : 'L') + point;
    last = point;
  }
  return alone ? path + "h0.1" : path;
}

std::string dots_path(const Plot& plot, const Series& s, int colour, const Axis& x, const Axis& y) {
  std::string path;
  std::string last;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    if (!drawn(plot, s, i)) continue;
    std::string mark = dot(x.at(s.x[i]), y.at(s.y[i]), colour);
    if (mark != last) path += mark;
    last = std::move(mark);
  }
  return path;
}

std::string curves(const Plot& plot, const Axis& x, const Axis& y) {
  const std::vector<int> colours = series_colours(plot.series);
  std::string out;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& s = plot.series[i];
    const std::string path = s.mark == Mark::points ? dots_path(plot, s, colours[i], x, y) : line_path(plot, s, x, y);
    if (!path.empty()) out += fmt::format("<path {} d=\"{}\"/>\n", line_style(s.mark, colours[i]), path);
  }
  return out;
}

std::string grid(const Axis& x, const Axis& y) {
  std::string out;
  for (const Tick& t : x.ticks) {
    out += svg::line(x.at(t.value), y.begin, x.at(t.value), y.end, svg::faint, t.label.empty() ? 0.6 : 1.2);
    if (!t.label.empty()) out += svg::text(x.at(t.value), y.begin + 20.0, t.label, {.anchor = svg::Anchor::middle});
  }
  for (const Tick& t : y.ticks) {
    out += svg::line(x.begin, y.at(t.value), x.end, y.at(t.value), svg::faint, t.label.empty() ? 0.6 : 1.2);
    if (!t.label.empty())
      out += svg::text(x.begin - tick_gap, y.at(t.value) + 5.5, t.label, {.anchor = svg::Anchor::end});
  }
  return out;
}

} // namespace

std::string to_svg(const Plot& plot, int width, int height) {
  check(plot, width, height);
  std::vector<double> x_values = drawn_values(plot, &Series::x);
  std::vector<double> y_values = drawn_values(plot, &Series::y);
  if (plot.least_extent > 0.0)
    for (std::vector<double>* values : {&x_values, &y_values})
      values->insert(values->end(), {-plot.least_extent, plot.least_extent});
  if (plot.equal_axes) match_extents(x_values, y_values, 0.86 * width / (0.75 * height));
  Axis x = fitted_axis(x_values, plot.log_x, 0.02, std::max(2, width / 105));
  Axis y = fitted_axis(y_values, plot.log_y, 0.05, std::max(2, height / 70));

  const svg::TextStyle label{.size = svg::label_size, .anchor = svg::Anchor::middle};
  const svg::TextStyle heading{.size = svg::title_size, .bold = true};
  const auto title = svg::wrapped(plot.title, width - 2.0 * svg::margin, 1.05 * svg::title_size);
  const auto y_label = svg::wrapped(plot.y_label, 0.6 * height, svg::label_size);
  x.begin = svg::margin + svg::text_height(y_label.size(), svg::label_size) + label_width(y) + tick_gap;
  x.end = width - svg::margin - 0.5 * label_width(x);
  const auto x_label = svg::wrapped(plot.x_label, x.end - x.begin, svg::label_size);
  const Legend entries = legend(plot.series, width - 2.0 * svg::margin);

  const double legend_top = svg::margin + svg::text_height(title.size(), svg::title_size);
  y.end = legend_top + entries.height + svg::margin;
  const double below = tick_room + svg::text_height(x_label.size(), svg::label_size) + svg::margin;
  y.begin = std::max(height - below, y.end + 0.5 * height);
  if (plot.equal_axes) match_scales(x, y);

  std::string body = svg::text_lines(svg::margin, svg::margin + svg::title_size - 3.0, title, heading);
  body += fmt::format("<g transform=\"translate({})\">\n{}</g>\n", svg::point(svg::margin, legend_top), entries.svg);
  body += grid(x, y);
  body += svg::frame(x.begin, y.end, x.end - x.begin, y.begin - y.end);
  body += curves(plot, x, y);
  if (x_values.empty()) body += svg::text(0.5 * (x.begin + x.end), 0.5 * (y.begin + y.end), "no data to draw", label);
  body += svg::text_lines(0.5 * (x.begin + x.end), y.begin + tick_room + svg::label_size, x_label, label);
  svg::TextStyle upward = label;
  upward.upward = true;
  body += svg::text_lines(svg::margin + svg::label_size - 2.0, 0.5 * (y.begin + y.end), y_label, upward);
  return svg::document(width, y.begin + below, plot.title, body);
}

} // namespace matrigrate::draw
