#include "study/table_readouts.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "observe/readout_table.hpp"
#include "statistics/sample.hpp"
#include "store/csv.hpp"
#include "store/naming.hpp"
#include "study/cell_tracks.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace matrigrate::study {

namespace {

constexpr std::size_t largest_table = std::size_t{1} << 28;
constexpr double not_defined = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<TableReadOut, 7> table{{
    {"share_f_adh_rel_low", "share of mature adhesions that ended below f_adh_rel = 0.5"},
    {"share_2_or_3_protrusions", "share of times with two or three protrusions"},
    {"migration_index_x", "way along x over the length of the path, sampled every 600 s"},
    {"parting_index", "cosine between displacement and the direction away from the nearest cell at the start"},
    {"share_in_contact", "share of times with a contact between cells"},
    {"nearest_um", "distance of the nearest other cell at the end"},
    {"order", "length of the mean unit vector of displacements over 10 min, mean over time"},
}};
constexpr std::size_t group_names = 4;

/// Share of the finite values that fulfil a condition.
template <class Condition>
double share(std::vector<double> values, const Condition& condition) {
  for (double& value : values)
    if (std::isfinite(value)) value = condition(value) ? 1.0 : 0.0;
  return statistics::mean_of_defined(values);
}

/// The way along x over the length of the path sampled at multiples of 600 s; NaN where nothing moved.
double migration_index(const CellTrack& track) {
  double length = 0.0;
  std::size_t last = 0;
  for (std::size_t i = 1; i < track.t.size(); ++i) {
    if (std::abs(std::remainder(track.t[i], 600.0)) > 1e-6) continue;
    length += std::hypot(track.x[i] - track.x[last], track.y[i] - track.y[last]);
    last = i;
  }
  return length > 0.0 ? (track.x[last] - track.x[0]) / length : not_defined;
}

/// Cosine between the way of a cell and the direction away from its nearest neighbour at the start.
double parting(const std::vector<CellTrack>& tracks, const CellTrack& own) {
  double least = std::numeric_limits<double>::infinity();
  double away_x = 0.0;
  double away_y = 0.0;
  for (const CellTrack& other : tracks) {
    const double dx = own.x[0] - other.x[0];
    const double dy = own.y[0] - other.y[0];
    const double distance = std::hypot(dx, dy);
    if (&other == &own || distance >= least) continue;
    least = distance;
    away_x = dx / distance;
    away_y = dy / distance;
  }
  const double dx = own.x.back() - own.x[0];
  const double dy = own.y.back() - own.y[0];
  const double way = std::hypot(dx, dy);
  return way > 0.0 ? (away_x * dx + away_y * dy) / way : not_defined;
}

} // namespace

std::span<const TableReadOut> table_readout_table() { return table; }

std::span<const TableReadOut> group_readout_table() { return table_readout_table().last(group_names); }

std::vector<double> table_readouts(const std::filesystem::path& folder) {
  const auto column = [&](const char* file, std::string_view name) {
    const std::string table = read_file(folder / file, largest_table);
    return store::naming(folder / file, [&] {
      const std::string header = "," + table.substr(0, table.find('\n')) + ",";
      if (header.find(fmt::format(",{},", name)) == std::string::npos)
        throw InputOutputError(fmt::format("has no column {}", name));
      if (!table.ends_with('\n')) throw InputOutputError("has been cut within a line");
      return store::csv_column(table, name);
    });
  };
  const std::vector<CellTrack> tracks = cell_tracks(folder);
  std::vector<double> index;
  for (const CellTrack& track : tracks) index.push_back(migration_index(track));
  std::vector<double> values{
      share(column("protrusions.csv", "f_adh_rel"), [](double f) { return f < low_relative_force; }),
      share(column("tracks.csv", "n_simultaneous"), [](double n) { return n == 2.0 || n == 3.0; }),
      statistics::mean_of_defined(index)};
  if (tracks.size() < 2) {
    values.resize(table.size(), not_defined);
    return values;
  }
  std::vector<double> away;
  for (const CellTrack& track : tracks) away.push_back(parting(tracks, track));
  const std::vector<double> nearest = column("group.csv", "nearest_um");
  values.insert(values.end(), {statistics::mean_of_defined(away),
                               share(column("group.csv", "n_contacts"), [](double n) { return n > 0.0; }),
                               nearest.empty() ? not_defined : nearest.back(),
                               statistics::mean_of_defined(column("group.csv", "order"))});
  return values;
}

std::string readouts_json() {
  using Json = nlohmann::ordered_json;
  Json all = Json::array();
  const auto add = [&](std::string_view name, std::string_view label, std::string_view unit, std::string_view meaning,
                       bool of_fibres) {
    all.push_back(
        {{"name", name}, {"label", label}, {"unit", unit}, {"meaning", meaning}, {"of_uniaxial_fibres", of_fibres}});
  };
  for (const ReadOutSpec& r : readout_table()) add(r.name, r.label, r.unit, r.meaning, r.of_fibres);
  for (const TableReadOut& r : table) add(r.name, r.name, r.name == "nearest_um" ? "um" : "", r.meaning, false);
  return all.dump(1) + "\n";
}

} // namespace matrigrate::study
