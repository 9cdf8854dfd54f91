#include "study_report/box_plot.hpp"

#include "draw/axis.hpp"
#include "draw/colour.hpp"
#include "draw/svg.hpp"
#include "statistics/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace matrigrate::study {

namespace {

namespace svg = draw::svg;

constexpr double margin = 14.0;
constexpr double plot_height = 230.0;
constexpr double label_step = 15.0; ///< distance of lines of a label [pixel]
constexpr double label_size = 12.0;
constexpr std::size_t max_points = 40;

std::string ring(double x, double y, double radius, std::string_view colour) {
  return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" fill-opacity=\"0.55\"/>\n", svg::coordinate(x),
                     svg::coordinate(y), radius, colour);
}

/// One sample around the vertical line at x.
std::string drawn_box(const std::vector<double>& sample, const draw::Axis& y, double x, double width) {
  if (sample.empty()) return {};
  const statistics::Box box = statistics::box(sample);
  const double half = 0.5 * width;
  const double top = y.at(box.high_quartile);
  std::string out = svg::rectangle(x - half, top, width, std::max(0.5, y.at(box.low_quartile) - top), "#dbe9f6");
  out += svg::frame(x - half, top, width, std::max(0.5, y.at(box.low_quartile) - top));
  out += svg::line(x - half, y.at(box.median), x + half, y.at(box.median), svg::dark, 2.4);
  out += svg::line(x, top, x, y.at(box.high_whisker), svg::dark, 1.2);
  out += svg::line(x, y.at(box.low_quartile), x, y.at(box.low_whisker), svg::dark, 1.2);
  for (std::size_t i = 0; i < sample.size(); ++i) { // side by side in a fixed pattern, so that equal values are seen
    const double place = std::fmod(0.618 * static_cast<double>(i), 1.0) - 0.5;
    out += ring(x + 0.7 * place * width, y.at(sample[i]), 3.0, draw::palette(0));
  }
  const double mean = y.at(statistics::moments(sample).mean);
  out += svg::line(x - 5.0, mean - 5.0, x + 5.0, mean + 5.0, draw::palette(1), 2.0);
  return out + svg::line(x - 5.0, mean + 5.0, x + 5.0, mean - 5.0, draw::palette(1), 2.0);
}

struct Panel {
  std::string svg;
  double height = 0.0;
};

Panel panel(const BoxPlot& plot, double width) {
  if (plot.labels.size() != plot.samples.size()) throw std::invalid_argument("a box plot needs a sample a label");
  std::vector<double> values;
  for (const auto& sample : plot.samples) values.insert(values.end(), sample.begin(), sample.end());
  draw::Axis y = draw::fitted_axis(values, false, 0.08, 5);
  const double left = margin + draw::label_width(y) + 8.0;
  const double top = margin + 26.0;
  y.begin = top + plot_height;
  y.end = top;
  std::string out = svg::text(margin, margin + 14.0, plot.title, {.size = svg::label_size, .bold = true});
  for (const draw::Tick& t : y.ticks) {
    out += svg::line(left, y.at(t.value), width - margin, y.at(t.value), svg::faint, 1.0);
    out += svg::text(left - 8.0, y.at(t.value) + 5.0, t.label, {.size = 14.0, .anchor = svg::Anchor::end});
  }
  const double step = (width - margin - left) / static_cast<double>(std::max<std::size_t>(1, plot.labels.size()));
  std::size_t lines = 0;
  for (std::size_t i = 0; i < plot.labels.size(); ++i) {
    const double x = left + (static_cast<double>(i) + 0.5) * step;
    out += drawn_box(plot.samples[i], y, x, std::min(46.0, 0.55 * step));
    const std::string label = fmt::format("{} (n = {})", plot.labels[i], plot.samples[i].size());
    const auto words = svg::wrapped(label, std::max(40.0, step - 8.0), label_size);
    for (std::size_t k = 0; k < words.size(); ++k)
      out += svg::text(x, y.begin + 18.0 + static_cast<double>(k) * label_step, words[k],
                       {.size = label_size, .anchor = svg::Anchor::middle});
    lines = std::max(lines, words.size());
  }
  out += svg::frame(left, top, width - margin - left, plot_height);
  return {out, y.begin + 18.0 + static_cast<double>(lines) * label_step + margin};
}

} // namespace

std::string to_svg(const std::vector<BoxPlot>& plots, const std::string& title) {
  std::size_t widest = 1;
  for (const BoxPlot& plot : plots) widest = std::max(widest, plot.labels.size());
  const double width = std::clamp(120.0 * static_cast<double>(widest) + 100.0, 480.0, 2400.0);
  const auto heading = svg::wrapped(title, width - 2.0 * margin, svg::title_size);
  double height = margin + svg::text_height(heading.size(), svg::title_size);
  std::string body =
      svg::text_lines(margin, margin + svg::title_size - 3.0, heading, {.size = svg::title_size, .bold = true});
  for (const BoxPlot& plot : plots) {
    const Panel drawn = panel(plot, width);
    body += fmt::format("<g transform=\"translate({})\">\n{}</g>\n", svg::point(0.0, height), drawn.svg);
    height += drawn.height;
  }
  return svg::document(width, height, title, body);
}

std::vector<BoxPlot> box_plots(const Study& study, const std::vector<Result>& results) {
  std::vector<BoxPlot> plots;
  const std::size_t points = std::min(max_points, study.points.size());
  for (const std::string& readout : study.readouts) {
    BoxPlot& plot = plots.emplace_back();
    plot.title = readout;
    for (std::size_t i = 0; i < points; ++i) {
      plot.labels.push_back(study.points[i].label);
      plot.samples.push_back(sample(results, i, readout));
    }
  }
  return plots;
}

std::string boxes_svg(const Study& study, const std::vector<Result>& results) {
  return to_svg(box_plots(study, results), study.title.empty() ? "Read-outs of the study" : study.title);
}

} // namespace matrigrate::study
