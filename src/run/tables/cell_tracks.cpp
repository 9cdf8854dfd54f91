#include "tables/cell_tracks.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "observe/readout_table.hpp"
#include "parameters/document.hpp"
#include "tables/table.hpp"
#include "tracks/read_tracks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace matrigrate::tracks {

namespace {

/// @throws InputOutputError if it is no number of a cell
std::uint32_t cell_number(double field) {
  if (field >= 1.0 && field < 4294967296.0 && field == std::floor(field)) return static_cast<std::uint32_t>(field);
  throw InputOutputError(fmt::format("has {} in the column track, where cells are numbered from 1", field));
}

/// @throws ConfigurationError if tracks have gaps
void require_no_gaps(const Tracks& found, const std::string& file) {
  std::vector<std::string> with_gaps;
  for (const Track& track : found.tracks)
    if (track.k.size() <= track.span()) with_gaps.push_back(excerpt(track.name, 40));
  if (with_gaps.empty()) return;
  const std::size_t count = with_gaps.size();
  with_gaps.resize(std::min<std::size_t>(count, 10));
  throw ConfigurationError({{file,
                             0,
                             0,
                             {},
                             fmt::format("{} of {} tracks have gaps ({}{}); a target needs tracks without", count,
                                         found.tracks.size(), fmt::join(with_gaps, ", "), count > 10 ? ", ..." : "")}});
}

} // namespace

std::vector<CellTrack> measured_tracks(const std::filesystem::path& file, TrackOptions options, TracksFor use,
                                       std::vector<std::string>& notes) {
  if (use == TracksFor::drawing) {
    options.shortest = 2;
    options.fewest = 1;
    options.may_stand = true;
  }
  const Tracks found = read_tracks(file, options);
  if (use == TracksFor::readouts) require_no_gaps(found, file.string());
  notes.insert(notes.end(), found.notes.begin(), found.notes.end());
  std::vector<CellTrack> all;
  for (const Track& track : found.tracks) {
    CellTrack& own = all.emplace_back(
        CellTrack{.cell = static_cast<std::uint32_t>(all.size() + 1), .t = {}, .x = track.x, .y = track.y});
    for (const std::size_t k : track.k) own.t.push_back(static_cast<double>(k) * found.interval);
  }
  return all;
}

std::string measured_csv(const std::vector<CellTrack>& tracks) {
  std::string csv = "track,t_s,x_um,y_um\n";
  for (const CellTrack& track : tracks)
    for (std::size_t i = 0; i < track.t.size(); ++i)
      csv += fmt::format("{},{},{},{}\n", track.cell, track.t[i], track.x[i], track.y[i]);
  return csv;
}

const std::vector<std::string>& readouts_of_tracks() {
  static const std::vector<std::string> names{"v_migr_abs_um_per_h", "v_migr_path_60s_um_per_h",
                                              "v_migr_path_600s_um_per_h", "msd_slope"};
  return names;
}

double readout_of(const CellTrack& track, std::string_view readout) {
  std::vector<TrackRow> rows;
  for (std::size_t i = 0; i < track.t.size(); ++i) {
    rows.emplace_back().t = track.t[i];
    rows.back().centre = Vec2(track.x[i], track.y[i]);
  }
  return std::get<double>(find_readout(readout)->value(matrigrate::readouts(rows, {}, Parameters())));
}

std::vector<CellTrack> cell_tracks(const std::filesystem::path& run_folder) {
  const std::filesystem::path file = run_folder / "tracks.csv";
  const std::string table = read_file(file, std::size_t{1} << 28);
  const std::vector<double> cell = store::csv_column(table, "track");
  const auto columns = naming(file, [&] { return store::csv_columns(table, {"t_s", "x_um", "y_um"}); });
  const std::vector<double>&t = columns[0], &x = columns[1], &y = columns[2];
  std::vector<CellTrack> tracks;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const std::uint32_t number = cell.empty() ? 1 : naming(file, [&] { return cell_number(cell[i]); });
    auto own = std::ranges::find(tracks, number, &CellTrack::cell);
    if (own == tracks.end()) own = tracks.insert(own, CellTrack{.cell = number, .t = {}, .x = {}, .y = {}});
    own->t.push_back(t[i]);
    own->x.push_back(x[i]);
    own->y.push_back(y[i]);
  }
  return tracks;
}

} // namespace matrigrate::tracks
