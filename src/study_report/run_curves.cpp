#include "study_report/run_curves.hpp"

#include "base/file.hpp"
#include "draw/plot.hpp"
#include "draw/svg.hpp"
#include "statistics/sample.hpp"
#include "store/csv.hpp"
#include "store/table.hpp"
#include "study/cell_tracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace matrigrate::study {

namespace {

constexpr std::size_t largest_table = std::size_t{1} << 28U;
constexpr double path_interval = 600.0; // [s]

/// Calls use(result, folder of the run) for the runs that are done, point by point.
template <class Use>
void each_done(const Study& study, const std::vector<Result>& results, const std::filesystem::path& folder,
               const Use& use) {
  for (std::size_t point = 0; point < study.points.size(); ++point)
    for (const Result& r : results)
      if (r.run.point == point && r.standing.done()) use(r, run_folder(folder, r.run));
}

/// A row of one of the tables of run_curves.hpp.
struct CurveRow {
  std::vector<double> numbers;
  std::string label;
};

/// The rows of a table: numbers, then the label.
std::vector<CurveRow> rows_of(std::string_view csv) {
  std::vector<CurveRow> rows;
  for (std::vector<std::string>& fields : store::read_csv(csv).rows) {
    CurveRow& row = rows.emplace_back();
    row.label = std::move(fields.back());
    fields.pop_back();
    for (const std::string& field : fields) row.numbers.push_back(store::csv_number(field));
  }
  return rows;
}

/// Lags of msd.csv, and the mean over the cells at each.
std::pair<std::vector<double>, std::vector<double>> msd_of(std::string_view table) {
  const std::vector<double> lag = store::csv_column(table, "lag_s");
  const std::vector<double> msd = store::csv_column(table, "msd_um2");
  std::map<double, std::vector<double>> at;
  for (std::size_t k = 0; k < lag.size(); ++k) at[lag[k]].push_back(msd[k]);
  std::pair<std::vector<double>, std::vector<double>> means;
  for (const auto& [l, values] : at) {
    means.first.push_back(l);
    means.second.push_back(statistics::moments(values).mean);
  }
  return means;
}

/// Rows by label, the labels in the order in which they first occur.
std::vector<std::pair<std::string, std::vector<CurveRow>>> by_label(const std::vector<CurveRow>& rows) {
  std::vector<std::pair<std::string, std::vector<CurveRow>>> groups;
  for (const CurveRow& row : rows) {
    auto group = std::ranges::find(groups, row.label, [](const auto& g) { return g.first; });
    if (group == groups.end()) group = groups.insert(groups.end(), {row.label, {}});
    group->second.push_back(row);
  }
  return groups;
}

} // namespace

std::vector<MeanMsd> mean_msd(const std::vector<Result>& results, std::size_t point,
                              const std::filesystem::path& study_folder) {
  std::vector<double> lags;
  std::vector<std::vector<double>> runs;
  for (const Result& result : results) {
    if (result.run.point != point || !result.standing.done()) continue;
    const std::string table = read_file(run_folder(study_folder, result.run) / "msd.csv", largest_table);
    const auto [here, msd] = msd_of(table);
    if (runs.empty() || here.size() < lags.size()) lags = here;
    runs.push_back(msd);
  }
  std::vector<MeanMsd> means;
  for (std::size_t k = 0; k < lags.size(); ++k) {
    std::vector<double> values;
    for (const std::vector<double>& run : runs) values.push_back(run[k]);
    const statistics::Moments m = statistics::moments(values);
    means.push_back({lags[k], m.mean, m.sd / std::sqrt(static_cast<double>(values.size())), values.size()});
  }
  return means;
}

std::string paths_csv(const Study& study, const std::vector<Result>& results,
                      const std::filesystem::path& study_folder) {
  const bool several = has_several_cells(study);
  std::string csv = fmt::format("replicate,t_s,x_um,y_um,{}point\n", several ? "cell," : "");
  each_done(study, results, study_folder, [&](const Result& r, const std::filesystem::path& folder) {
    for (const auto& [cell, t, x, y] : cell_tracks(folder))
      for (std::size_t k = 0; k < t.size(); ++k) {
        if (std::abs(std::remainder(t[k], path_interval)) > 1e-6) continue;
        csv +=
            fmt::format("{},{:.0f},{:.2f},{:.2f},{}{}\n", r.run.replicate, t[k], x[k] - x[0], y[k] - y[0],
                        several ? fmt::format("{:.0f},", cell) : "", store::csv_text(study.points[r.run.point].label));
      }
  });
  return csv;
}

std::string msd_csv(const Study& study, const std::vector<Result>& results, const std::filesystem::path& study_folder) {
  std::string csv = "lag_s,msd_um2,sem_um2,n_runs,point\n";
  for (std::size_t point = 0; point < study.points.size(); ++point)
    for (const MeanMsd& m : mean_msd(results, point, study_folder))
      csv += fmt::format("{:.0f},{:.4g},{},{},{}\n", m.lag, m.mean,
                         std::isfinite(m.sem) ? fmt::format("{:.4g}", m.sem) : std::string(), m.runs,
                         store::csv_text(study.points[point].label));
  return csv;
}

std::string adhesions_csv(const Study& study, const std::vector<Result>& results,
                          const std::filesystem::path& study_folder) {
  std::string csv = "replicate,length_um,f_mat,f_adh_rel,point\n";
  each_done(study, results, study_folder, [&](const Result& r, const std::filesystem::path& folder) {
    const std::string table = read_file(folder / "protrusions.csv", largest_table);
    const std::vector<double> length = store::csv_column(table, "length_um");
    const std::vector<double> f_mat = store::csv_column(table, "f_mat");
    const std::vector<double> force = store::csv_column(table, "f_adh_rel");
    for (std::size_t k = 0; k < force.size(); ++k)
      if (std::isfinite(force[k]))
        csv += fmt::format("{},{:.2f},{:.3f},{:.3f},{}\n", r.run.replicate, length[k], f_mat[k], force[k],
                           store::csv_text(study.points[r.run.point].label));
  });
  return csv;
}

std::string paths_svg(std::string_view paths_csv) {
  const auto groups = by_label(rows_of(paths_csv));
  double extent = 1.0;
  for (const auto& [label, rows] : groups)
    for (const CurveRow& row : rows) extent = std::max({extent, std::abs(row.numbers[2]), std::abs(row.numbers[3])});
  std::vector<std::string> panels;
  for (const auto& [label, rows] : groups) {
    std::map<std::pair<double, double>, draw::Series> paths; // by replicate and cell
    std::set<double> runs;
    for (const CurveRow& row : rows) {
      runs.insert(row.numbers[0]);
      draw::Series& series = paths[{row.numbers[0], row.numbers.size() > 4 ? row.numbers[4] : 1.0}];
      series.x.push_back(row.numbers[2]);
      series.y.push_back(row.numbers[3]);
    }
    draw::Plot plot{.title = fmt::format("{} (n = {})", label, runs.size()), .x_label = "x [um]", .y_label = "y [um]"};
    plot.equal_axes = true;
    plot.least_extent = extent;
    for (auto& [path, series] : paths) plot.series.push_back(std::move(series));
    panels.push_back(draw::to_svg(plot, 430, 400));
  }
  return draw::svg::sheet(panels, 3, "Paths of the centres of mass, from a common origin");
}

std::string msd_svg(std::string_view msd_csv) {
  draw::Plot plot{
      .title = "Mean square displacement, mean over the runs", .x_label = "lag [min]", .y_label = "MSD [um^2]"};
  plot.log_x = plot.log_y = true;
  for (const auto& [label, rows] : by_label(rows_of(msd_csv))) {
    draw::Series& series = plot.series.emplace_back(draw::Series{.label = label});
    for (const CurveRow& row : rows) {
      series.x.push_back(row.numbers[0] / 60.0);
      series.y.push_back(row.numbers[1]);
    }
  }
  return draw::to_svg(plot);
}

std::string adhesions_svg(std::string_view adhesions_csv) {
  draw::Plot plot{.title = "Relative force f_adh_rel at the end of adhesions",
                  .x_label = "f_adh_rel [-]",
                  .y_label = "share below it [-]"};
  for (const auto& [label, rows] : by_label(rows_of(adhesions_csv))) {
    std::vector<double> forces;
    for (const CurveRow& row : rows) forces.push_back(row.numbers[3]);
    std::ranges::sort(forces);
    draw::Series& series =
        plot.series.emplace_back(draw::Series{.label = fmt::format("{} (n = {})", label, forces.size())});
    for (std::size_t k = 0; k < forces.size(); ++k)
      for (const std::size_t below : {k, k + 1}) { // a step up
        series.x.push_back(forces[k]);
        series.y.push_back(static_cast<double>(below) / static_cast<double>(forces.size()));
      }
  }
  return draw::to_svg(plot);
}

} // namespace matrigrate::study
