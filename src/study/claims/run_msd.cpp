#include "claims/run_msd.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "tables/csv.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

namespace matrigrate::study {

namespace {

constexpr double path_interval = 600.0; // of paths.csv [s]

/// Paths of the cells of a run, by what the table calls them.
using Paths = std::map<std::string, std::vector<TrackRow>>;
/// By the label of the point and the replicate.
using PathsByRun = std::map<std::pair<std::string, std::string>, Paths>;

PathsByRun paths_in(const std::string& text) {
  const store::CsvTable table = store::read_csv(text);
  const auto column = [&](const char* name) {
    if (const auto found = table.column(name)) return *found;
    throw InputOutputError(fmt::format("has no column {}", name));
  };
  const std::size_t point = column("point"), replicate = column("replicate"), t = column("t_s"), x = column("x_um"),
                    y = column("y_um");
  const auto cell = table.column("cell");
  PathsByRun all;
  for (const std::vector<std::string>& row : table.rows) {
    TrackRow& at = all[{row[point], row[replicate]}][cell ? row[*cell] : ""].emplace_back();
    at.t = store::csv_number(row[t]);
    at.centre = Vec2(store::csv_number(row[x]), store::csv_number(row[y]));
  }
  return all;
}

} // namespace

MsdCurves run_msd(const Study& study, const std::vector<Result>& results,
                  const std::vector<std::filesystem::path>& tables) {
  constexpr std::size_t largest_table = std::size_t{1} << 28U;
  PathsByRun all;
  for (const std::filesystem::path& file : tables)
    if (std::filesystem::exists(file)) naming(file, [&] { all.merge(paths_in(read_file(file, largest_table))); });
  MsdCurves curves;
  for (const Result& r : results) {
    MsdCurves cells;
    const auto found = all.find({study.points[r.run.point].label, fmt::to_string(r.run.replicate)});
    if (found != all.end())
      for (const auto& [cell, path] : found->second) cells.push_back(mean_square_displacement(path, path_interval));
    curves.push_back(mean_curve(cells));
  }
  return curves;
}

} // namespace matrigrate::study
