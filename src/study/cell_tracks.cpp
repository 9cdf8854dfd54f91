#include "study/cell_tracks.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "observe/readouts.hpp"
#include "parameters/scan.hpp"
#include "store/csv.hpp"
#include "store/naming.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

namespace matrigrate::study {

namespace {

constexpr std::array<std::string_view, 4> track_file_columns{"track", "t_s", "x_um", "y_um"};
constexpr double off_grid = 0.01; // of an interval

/// A whole field as a finite number.
std::optional<double> finite_number(std::string_view field) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Reads the rows of a file of tracks, and collects its faults.
class TrackFile {
public:
  TrackFile(const std::filesystem::path& file, TracksFor use) : m_file(file.string()), m_use(use) {
    try {
      std::string text = read_file(file, std::size_t{1} << 28);
      std::erase(text, '\r');
      m_table = store::read_csv(text);
    } catch (const InputOutputError& error) {
      const std::string what = error.what(); // "line 3: has 4 fields, ..."
      const std::size_t colon = what.find(": ");
      if (!what.starts_with("line ") || colon == std::string::npos) throw;
      fault(std::stoul(what.substr(5)), what.substr(colon + 2));
      throw ConfigurationError(std::move(m_faults));
    }
  }

  std::vector<CellTrack> tracks() {
    find_columns();
    if (m_faults.empty()) read_rows();
    if (m_faults.empty()) check_steps();
    if (m_faults.empty() && m_tracks.empty()) fault(0, "has no track");
    if (m_faults.empty() && m_use == TracksFor::readouts && m_tracks.size() < 2)
      fault(0, fmt::format("has {} track; the error of a mean needs 2 or more", m_tracks.size()));
    if (!m_faults.empty()) throw ConfigurationError(std::move(m_faults));
    return std::move(m_tracks);
  }

private:
  void fault(std::size_t line, std::string message) {
    constexpr std::size_t most = 20;
    if (m_faults.size() < most)
      m_faults.push_back({m_file, static_cast<int>(line), line == 0 ? 0 : 1, {}, std::move(message)});
  }

  void find_columns() {
    for (std::size_t c = 0; c < track_file_columns.size(); ++c) {
      const auto found = m_table.column(track_file_columns[c]);
      if (!found)
        fault(1, fmt::format("has no column {}; its columns are {}. In Python, "
                             "matrigrate.tracks.read(FILE).table().to_csv(\"tracks.csv\", index=False) makes the file "
                             "that is wanted",
                             track_file_columns[c], excerpt(fmt::format("{}", fmt::join(m_table.header, ", ")))));
      m_column[c] = found.value_or(0);
    }
  }

  void read_rows() {
    std::map<std::string, std::size_t> numbers;
    for (std::size_t i = 0; i < m_table.rows.size(); ++i) {
      const std::vector<std::string>& row = m_table.rows[i];
      std::array<double, 3> values{};
      for (std::size_t c = 1; c < track_file_columns.size(); ++c) {
        const std::string& field = row[m_column[c]];
        if (const auto number = finite_number(field))
          values[c - 1] = *number;
        else
          fault(i + 2, fmt::format("{}: \"{}\" is no finite number", track_file_columns[c], excerpt(field)));
      }
      const auto [own, added] = numbers.emplace(row[m_column[0]], m_tracks.size());
      if (added) {
        m_tracks.push_back({.cell = static_cast<double>(m_tracks.size() + 1), .t = {}, .x = {}, .y = {}});
        m_lines.emplace_back();
      }
      CellTrack& track = m_tracks[own->second];
      m_lines[own->second].push_back(i + 2);
      track.t.push_back(values[0]);
      track.x.push_back(values[1]);
      track.y.push_back(values[2]);
    }
  }

  /// Rising times and, for read-outs, one interval without gaps; then times from 0.
  void check_steps() {
    double interval = 0.0;
    for (const CellTrack& track : m_tracks)
      if (interval <= 0.0 && track.t.size() > 1) interval = track.t[1] - track.t[0];
    for (std::size_t k = 0; k < m_tracks.size(); ++k) {
      CellTrack& track = m_tracks[k];
      if (track.t.size() < 2) fault(m_lines[k][0], "is the only row of its track");
      for (std::size_t i = 1; i < track.t.size(); ++i)
        if (const double step = track.t[i] - track.t[i - 1]; m_use == TracksFor::drawing && !(step > 0.0))
          fault(m_lines[k][i], fmt::format("is {:g} s after the row before of its track; times must rise", step));
        else if (m_use == TracksFor::readouts && !(std::abs(step - interval) <= off_grid * interval))
          fault(m_lines[k][i], fmt::format("is {:g} s after the row before of its track; the first step is {:g} s: one "
                                           "interval without gaps is needed",
                                           step, interval));
      const double start = track.t.empty() ? 0.0 : track.t[0];
      for (double& t : track.t) t -= start;
    }
  }

  std::string m_file;
  TracksFor m_use;
  store::CsvTable m_table;
  std::array<std::size_t, track_file_columns.size()> m_column{};
  std::vector<CellTrack> m_tracks;
  std::vector<std::vector<std::size_t>> m_lines; ///< of the rows of each track
  std::vector<Fault> m_faults;
};

} // namespace

std::vector<CellTrack> measured_tracks(const std::filesystem::path& file, TracksFor use) {
  return TrackFile(file, use).tracks();
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
  const ReadOuts all = readouts(rows, {}, Parameters());
  const std::array<double, 4> values{all.v_migr_abs, all.v_migr_path_60s, all.v_migr_path_600s, all.msd_slope};
  const auto found = std::ranges::find(readouts_of_tracks(), readout);
  return values.at(static_cast<std::size_t>(found - readouts_of_tracks().begin()));
}

std::vector<CellTrack> cell_tracks(const std::filesystem::path& run_folder) {
  const std::filesystem::path file = run_folder / "tracks.csv";
  const std::string table = read_file(file, std::size_t{1} << 28);
  const std::vector<double> cell = store::csv_column(table, "track");
  const auto columns = store::naming(file, [&] { return store::csv_columns(table, {"t_s", "x_um", "y_um"}); });
  const std::vector<double>&t = columns[0], &x = columns[1], &y = columns[2];
  std::vector<CellTrack> tracks;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double number = cell.empty() ? 1.0 : cell[i];
    auto own = std::ranges::find(tracks, number, &CellTrack::cell);
    if (own == tracks.end()) own = tracks.insert(own, CellTrack{.cell = number, .t = {}, .x = {}, .y = {}});
    own->t.push_back(t[i]);
    own->x.push_back(x[i]);
    own->y.push_back(y[i]);
  }
  return tracks;
}

} // namespace matrigrate::study
