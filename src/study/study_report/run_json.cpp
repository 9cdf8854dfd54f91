#include "study_report/run_json.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/checkpoint.hpp"
#include "tables/cell_tracks.hpp"
#include "tables/csv.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <system_error>

namespace matrigrate::study {

namespace {

using Json = nlohmann::ordered_json; // NaN is written as null

constexpr std::size_t max_column_file_bytes = std::size_t{1} << 28U;
constexpr std::size_t path_points = 100;

std::vector<double> column(const std::filesystem::path& file, std::string_view name) {
  return store::csv_column(read_file(file, max_column_file_bytes), name);
}

/// Lines of several cells are one list, with null between them.
void begin_line(Json& lines) {
  for (const char* axis : {"x_um", "y_um"})
    if (!lines[axis].empty()) lines[axis].push_back(nullptr);
}

/// At most path_points of each cell's path, the last one among them.
Json path_json(const std::filesystem::path& folder) {
  const std::vector<tracks::CellTrack> tracks = tracks::cell_tracks(folder);
  if (tracks.empty()) return {};
  Json path{{"x_um", Json::array()}, {"y_um", Json::array()}};
  for (const tracks::CellTrack& track : tracks) {
    begin_line(path);
    const std::size_t n = std::min(track.x.size(), path_points);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = n == 1 ? 0 : k * (track.x.size() - 1) / (n - 1);
      path["x_um"].push_back(track.x[i]);
      path["y_um"].push_back(track.y[i]);
    }
  }
  return path;
}

std::string_view status_of(const Standing& standing) {
  if (standing.status == RunState::done || standing.status == RunState::failed) return to_string(standing.status);
  return standing.status == RunState::unfinished ? "running" : "pending";
}

/// The cells where the run ended; nothing if its checkpoint was deleted or is damaged.
Json outline_json(const std::filesystem::path& checkpoint) {
  const auto shown = [](double um) { return std::round(100.0 * um) / 100.0; };
  Json outline{{"x_um", Json::array()}, {"y_um", Json::array()}};
  try {
    const State end = store::read_checkpoint(checkpoint).state;
    for (const Cell& cell : end.cells) {
      begin_line(outline);
      for (const Vec2& x : cell.cortex.x) {
        outline["x_um"].push_back(shown(x.x()));
        outline["y_um"].push_back(shown(x.y()));
      }
    }
  } catch (const InputOutputError&) {
    return {};
  }
  return outline;
}

} // namespace

Json readouts_of_run(const Study& study, const Result& result, const Json& place) {
  Json json{{"id", result.run.hash},
            {"point", place},
            {"replicate", result.run.replicate},
            {"seed", result.run.seed},
            {"status", status_of(result.standing)},
            {"reason", result.standing.reason},
            {"report", nullptr},
            {"readouts", Json::object()},
            {"path", nullptr},
            {"outline", nullptr},
            {"f_adh_rel", Json::array()}};
  if (result.standing.done())
    for (const std::string& name : study.readouts) json["readouts"][name] = result.readouts[readout_column(name)];
  return json;
}

Json run_json(const Study& study, const std::filesystem::path& study_folder, const Result& result, const Json& place) {
  const std::filesystem::path folder = run_folder(study_folder, result.run);
  Json json = readouts_of_run(study, result, place);
  std::error_code error;
  if (std::filesystem::exists(folder / "report.html", error))
    json["report"] = (folder.lexically_relative(study_folder) / "report.html").generic_string();
  if (!result.standing.done()) return json;
  json["path"] = path_json(folder);
  json["outline"] = outline_json(folder / store::checkpoint_name);
  for (const double force : column(folder / "protrusions.csv", "f_adh_rel"))
    if (std::isfinite(force)) json["f_adh_rel"].push_back(force);
  return json;
}

} // namespace matrigrate::study
