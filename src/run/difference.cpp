#include "run/difference.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "observe/readout_table.hpp"
#include "parameters/changes.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "parameters/version.hpp"
#include "run/folder_state.hpp"
#include "run/run_record.hpp"
#include "tables/state_json.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

namespace matrigrate::run {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_file = std::size_t{1} << 28U;

/// One side of a comparison: a scenario, or a run with what it wrote.
struct Side {
  std::string name;
  Parameters p;
  Json record;  ///< run.json; null of a scenario
  Json summary; ///< summary.json; null of a scenario, and of a run that has not ended
  std::string tracks;
};

Json json_of(const fs::path& file) {
  if (!fs::exists(file)) return nullptr;
  return store::read_json_object(file, largest_file);
}

Side side(const std::string& name) {
  std::error_code error;
  if (!fs::is_directory(name, error))
    return {.name = name, .p = read_parameters(name), .record = {}, .summary = {}, .tracks = {}};
  const fs::path folder = name;
  require(look_at(folder), Use::see_run);
  Side one{.name = name,
           .p = read_parameters(folder / "scenario.resolved.toml"),
           .record = read_record(folder),
           .summary = json_of(folder / "summary.json"),
           .tracks = {}};
  if (const fs::path tracks = folder / "tracks.csv"; fs::exists(tracks)) {
    one.tracks = read_file(tracks, largest_file);
    if (one.tracks.empty()) throw InputOutputError(fmt::format("{}: is empty", tracks.string()));
  }
  return one;
}

/// [name, value of a, value of b] of the read-outs that both have; empty values are null.
Json readouts_of_both(const Side& a, const Side& b) {
  Json list = Json::array();
  for (const ReadOutSpec& spec : readout_table())
    if (a.summary.contains(spec.name) && b.summary.contains(spec.name))
      list.push_back({spec.name, a.summary.at(spec.name), b.summary.at(spec.name)});
  return list;
}

store::CsvTable tracks_of(const Side& one) {
  return naming(fs::path(one.name) / "tracks.csv", [&one] {
    store::CsvTable table = store::read_csv(one.tracks);
    if (!table.column("t_s")) throw InputOutputError("has no column t_s");
    return table;
  });
}

/// Time of the first row of tracks.csv in which two runs differ [s]; nothing if one holds the other.
std::optional<double> first_difference(const Side& a, const Side& b) {
  if (a.tracks.empty() || b.tracks.empty()) return {};
  const store::CsvTable left = tracks_of(a), right = tracks_of(b);
  const auto time = left.column("t_s");
  for (std::size_t k = 0; time && k < std::min(left.rows.size(), right.rows.size()); ++k)
    if (left.rows[k] != right.rows[k]) return store::csv_number(left.rows[k][*time]);
  return {};
}

} // namespace

std::vector<std::array<std::string, 3>> parameters_that_differ(const Parameters& a, const Parameters& b) {
  std::vector<std::array<std::string, 3>> list;
  for (const Row& row : schema())
    if (differs(row, a, b)) list.push_back({std::string(row.path), value_text(row, a), value_text(row, b)});
  for (const Gone& parameter : gone())
    if (gone_value(parameter, a) != gone_value(parameter, b))
      list.push_back({std::string(parameter.path), gone_value(parameter, a), gone_value(parameter, b)});
  if (cells_text(a) != cells_text(b)) list.push_back({"cells", cells_text(a), cells_text(b)});
  if (changes_text(a) != changes_text(b)) list.push_back({"changes", changes_text(a), changes_text(b)});
  return list;
}

Json difference(const std::string& of_a, const std::string& of_b) {
  const Side a = side(of_a), b = side(of_b);
  Json found{{"a", a.name}, {"b", b.name}, {"parameters", parameters_that_differ(a.p, b.p)}};
  if (a.record.is_null() || b.record.is_null()) return found;
  const std::string hash = text_of(a.record, "trajectory_hash");
  found["same_trajectory"] = !hash.empty() && hash == text_of(b.record, "trajectory_hash");
  const auto first = first_difference(a, b);
  found["first_difference_s"] = first ? Json(*first) : Json(nullptr);
  for (const char* key : {"status", "version", "git_hash", "t_s", "wall_time_s", "trajectory_hash"})
    found["runs"][key] = {a.record.value(key, Json()), b.record.value(key, Json())};
  found["readouts"] = readouts_of_both(a, b);
  return found;
}

} // namespace matrigrate::run
