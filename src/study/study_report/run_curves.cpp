#include "study_report/run_curves.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "statistics/sample.hpp"
#include "store/checkpoint.hpp"
#include "tables/cell_tracks.hpp"
#include "tables/csv.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <string_view>
#include <utility>

namespace matrigrate::study {

namespace {

constexpr double path_interval = 600.0; // [s]
constexpr std::size_t replicates_shown = 3;

/// Calls use(result, folder of the run) for the runs that are done, point by point.
template <class Use>
void each_done(const Study& study, const std::vector<Result>& results, const std::filesystem::path& folder,
               const Use& use) {
  for (std::size_t point = 0; point < study.points.size(); ++point)
    for (const Result& r : results)
      if (r.run.point == point && r.standing.done()) use(r, run_folder(folder, r.run));
}

/// Columns of a table of a run.
std::vector<std::vector<double>> columns_of(const std::filesystem::path& file,
                                            std::initializer_list<std::string_view> names) {
  return naming(file, [&] { return store::csv_columns(read_file(file, largest_table), names); });
}

/// Lags of msd.csv, and the mean over the cells at each.
std::pair<std::vector<double>, std::vector<double>> msd_of(const std::filesystem::path& file) {
  const auto columns = columns_of(file, {"lag_s", "msd_um2"});
  const std::vector<double>&lag = columns[0], &msd = columns[1];
  std::map<double, std::vector<double>> at;
  for (std::size_t k = 0; k < lag.size(); ++k)
    if (!std::isnan(lag[k])) at[lag[k]].push_back(msd[k]);
  std::pair<std::vector<double>, std::vector<double>> means;
  for (const auto& [l, values] : at) {
    means.first.push_back(l);
    means.second.push_back(statistics::moments(values).mean);
  }
  return means;
}

} // namespace

std::vector<MeanMsd> mean_msd(const std::vector<Result>& results, std::size_t point,
                              const std::filesystem::path& study_folder) {
  std::vector<double> lags;
  std::vector<std::vector<double>> runs;
  for (const Result& result : results) {
    if (result.run.point != point || !result.standing.done()) continue;
    const auto [here, msd] = msd_of(run_folder(study_folder, result.run) / "msd.csv");
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
    for (const auto& [cell, t, x, y] : tracks::cell_tracks(folder))
      for (std::size_t k = 0; k < t.size(); ++k) {
        if (std::abs(std::remainder(t[k], path_interval)) > 1e-6) continue;
        csv += fmt::format("{},{:.0f},{:.2f},{:.2f},{}{}\n", r.run.replicate, t[k], x[k] - x[0], y[k] - y[0],
                           several ? fmt::format("{},", cell) : "", csv_text(study.points[r.run.point].label));
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
                         csv_text(study.points[point].label));
  return csv;
}

std::string adhesions_csv(const Study& study, const std::vector<Result>& results,
                          const std::filesystem::path& study_folder) {
  std::string csv = "replicate,length_um,f_mat,f_adh_rel,point\n";
  each_done(study, results, study_folder, [&](const Result& r, const std::filesystem::path& folder) {
    const auto columns = columns_of(folder / "protrusions.csv", {"length_um", "f_mat", "f_adh_rel"});
    const std::vector<double>&length = columns[0], &f_mat = columns[1], &force = columns[2];
    for (std::size_t k = 0; k < force.size(); ++k)
      if (std::isfinite(force[k]))
        csv += fmt::format("{},{:.2f},{:.3f},{:.3f},{}\n", r.run.replicate, length[k], f_mat[k], force[k],
                           csv_text(study.points[r.run.point].label));
  });
  return csv;
}

std::string shapes_csv(const Study& study, const std::vector<Result>& results,
                       const std::filesystem::path& study_folder) {
  std::string csv = "replicate,x_um,y_um,point\n";
  for (const Result& r : results) {
    if (!r.standing.done() || r.run.replicate > replicates_shown) continue;
    const std::filesystem::path checkpoint = run_folder(study_folder, r.run) / store::checkpoint_name;
    if (!std::filesystem::exists(checkpoint)) continue;
    const CortexState cortex = store::read_checkpoint(checkpoint).state.cells.at(0).cortex;
    for (std::size_t i = 0; i < cortex.size(); i += 2)
      csv += fmt::format("{},{:.2f},{:.2f},{}\n", r.run.replicate, cortex.x[i].x(), cortex.x[i].y(),
                         csv_text(study.points[r.run.point].label));
  }
  return csv;
}

} // namespace matrigrate::study
