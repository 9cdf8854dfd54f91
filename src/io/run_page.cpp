#include "io/run_page.hpp"

#include "io/page_parts.hpp"
#include "io/plot.hpp"
#include "io/svg.hpp"

#include <fmt/format.h>

namespace matrigrate::io {

namespace {

constexpr double seconds_an_hour = 3600.0;

/// A quantity of each row over time in hours.
template <class Value>
Series over_time(std::span<const TrackRow> rows, const std::string& label, const Value& value) {
  Series series{.label = label};
  for (const TrackRow& row : rows) {
    series.x.push_back(row.t / seconds_an_hour);
    series.y.push_back(value(row));
  }
  return series;
}

Plot path_plot(std::span<const TrackRow> rows) {
  Series series{.label = "centre of mass"};
  Series start{.label = "start", .mark = Mark::points};
  for (const TrackRow& row : rows) {
    series.x.push_back(row.centre.x());
    series.y.push_back(row.centre.y());
  }
  if (!rows.empty()) {
    start.x.push_back(rows.front().centre.x());
    start.y.push_back(rows.front().centre.y());
  }
  return {.title = "Path", .x_label = "x [um]", .y_label = "y [um]", .series = {series, start}, .equal_axes = true};
}

/// Speed from row to row, at the middle of the two.
Plot speed_plot(std::span<const TrackRow> rows) {
  Series series{};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double dt = (rows[i].t - rows[i - 1].t) / seconds_an_hour;
    series.x.push_back(0.5 * (rows[i].t + rows[i - 1].t) / seconds_an_hour);
    series.y.push_back((rows[i].centre - rows[i - 1].centre).norm() / dt);
  }
  return {.title = "Speed from row to row", .x_label = "time [h]", .y_label = "speed [um/h]", .series = {series}};
}

Plot area_plot(std::span<const TrackRow> rows) {
  return {.title = "Area of the cell",
          .x_label = "time [h]",
          .y_label = "area [um^2]",
          .series = {over_time(rows, "", [](const TrackRow& row) { return row.area; })}};
}

Plot protrusion_plot(std::span<const TrackRow> rows) {
  return {.title = "Protrusions",
          .x_label = "time [h]",
          .y_label = "number",
          .series = {over_time(rows, "alive", [](const TrackRow& row) { return static_cast<double>(row.alive()); }),
                     over_time(rows, "adhered", [](const TrackRow& row) {
                       return static_cast<double>(row.in_phase[1] + row.in_phase[2]);
                     })}};
}

std::string table(const ReadOuts& readouts) {
  std::string out = "<table>\n<thead><tr><th scope=\"col\">read-out</th><th scope=\"col\">value</th>"
                    "<th scope=\"col\">in summary.csv</th></tr></thead>\n<tbody>\n";
  for (const NamedValue& v : named_values(readouts))
    out += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", svg::escape(v.meaning), readable(v.value),
                       svg::escape(v.name));
  return out + "</tbody>\n</table>\n";
}

} // namespace

std::string run_page(const RunReport& report) {
  std::string out = page_head(report.title) + fmt::format("<p>{}</p>\n", svg::escape(report.status));
  out += "<section>\n<h2>The cell over time</h2>\n";
  out += figures_html(
      {{"snapshots", "Cell and matrix. The larger snapshots of the whole matrix are in the folder snapshots.",
        report.contact_sheet}},
      "s1");
  out += "</section>\n<section>\n<h2>Read-outs</h2>\n" + table(report.readouts);
  out += "</section>\n<section>\n<h2>Path, shape and protrusions</h2>\n";
  out += figures_html(
      {{"path", "Path of the centre of mass.", to_svg(path_plot(report.rows))},
       {"speed", "Displacement between two rows of tracks.csv over their distance in time.",
        to_svg(speed_plot(report.rows))},
       {"area", "Area inside the cortex.", to_svg(area_plot(report.rows))},
       {"protrusions", "Protrusions alive, and those of them that adhere.", to_svg(protrusion_plot(report.rows))}},
      "s2");
  return out + "</section>\n" + page_end(report.provenance);
}

} // namespace matrigrate::io
