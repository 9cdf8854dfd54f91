#include "apps/terminal/terminal.hpp"
#include "apps/terminal/text_table.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "observe/readout_table.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "run/run_record.hpp"
#include "store/csv.hpp"
#include "store/naming.hpp"
#include "store/state_json.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <optional>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;
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
  if (!fs::exists(folder / "run.json"))
    throw InputOutputError(fmt::format("{}: is not the folder of a run (it has no run.json)", name));
  Side one{.name = name,
           .p = read_parameters(folder / "scenario.resolved.toml"),
           .record = run::read_record(folder),
           .summary = json_of(folder / "summary.json"),
           .tracks = {}};
  if (const fs::path tracks = folder / "tracks.csv"; fs::exists(tracks)) {
    one.tracks = read_file(tracks, largest_file);
    if (one.tracks.empty()) throw InputOutputError(fmt::format("{}: is empty", tracks.string()));
  }
  return one;
}

/// [path, value of a, value of b] of the parameters that differ.
Json parameters_that_differ(const Side& a, const Side& b) {
  Json list = Json::array();
  for (const Row& row : schema())
    if (const std::string left = value_text(row, a.p), right = value_text(row, b.p); left != right)
      list.push_back({row.path, left, right});
  if (const std::string left = cells_text(a.p), right = cells_text(b.p); left != right)
    list.push_back({"cells", left, right});
  return list;
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
  return store::naming(fs::path(one.name) / "tracks.csv", [&one] {
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

Json comparison(const Side& a, const Side& b) {
  Json found{{"a", a.name}, {"b", b.name}, {"parameters", parameters_that_differ(a, b)}};
  if (a.record.is_null() || b.record.is_null()) return found;
  const std::string hash = run::text_of(a.record, "trajectory_hash");
  found["same_trajectory"] = !hash.empty() && hash == run::text_of(b.record, "trajectory_hash");
  const auto first = first_difference(a, b);
  found["first_difference_s"] = first ? Json(*first) : Json(nullptr);
  for (const char* key : {"status", "version", "git_hash", "t_s", "wall_time_s", "trajectory_hash"})
    found["runs"][key] = {a.record.value(key, Json()), b.record.value(key, Json())};
  found["readouts"] = readouts_of_both(a, b);
  return found;
}

std::string cell_text(const Json& value) {
  return value.is_null()           ? "-"
         : value.is_string()       ? value.get<std::string>()
         : value.is_number_float() ? fmt::format("{:.6g}", value.get<double>())
                                   : value.dump();
}

std::string table_text(const Json& rows, const Json& names, const char* title) {
  std::vector<std::vector<std::string>> cells{{title, names.at(0), names.at(1)}};
  for (const Json& row : rows) cells.push_back({cell_text(row.at(0)), cell_text(row.at(1)), cell_text(row.at(2))});
  return aligned(cells, 3);
}

std::string text_of(const Json& found) {
  const Json names{found.at("a"), found.at("b")};
  std::string text = found.at("parameters").empty() ? "The parameters are the same.\n"
                                                    : table_text(found.at("parameters"), names, "parameter");
  if (!found.contains("runs")) return text;
  Json runs = Json::array();
  for (const auto& [key, values] : found.at("runs").items()) runs.push_back({key, values.at(0), values.at(1)});
  text += "\n" + table_text(runs, names, "run");
  if (!found.at("readouts").empty()) text += "\n" + table_text(found.at("readouts"), names, "read-out");
  if (found.at("same_trajectory").get<bool>()) return text + "\nThe trajectories have the same bits.\n";
  if (found.at("first_difference_s").is_null()) return text + "\nNo row of tracks.csv that both have differs.\n";
  return text + fmt::format("\nThe tracks differ from {:g} s on.\n", found.at("first_difference_s").get<double>());
}

int compare(const std::string& a, const std::string& b, bool json) {
  const Json found = comparison(side(a), side(b));
  print(json ? found.dump(2, ' ', false, Json::error_handler_t::replace) + "\n" : text_of(found));
  return done;
}

} // namespace

void add_diff(CLI::App& app, Action& chosen) {
  CLI::App* verb =
      app.add_subcommand("diff", "Compare two runs or two scenarios: parameters, read-outs, first difference");
  verb->footer(
      "Each of A and B is the folder of a run or a scenario file. Of two runs it also compares version, status, "
      "read-outs\n"
      "and trajectory, and tells from when on the tracks differ.\n"
      "--json prints {a, b, parameters: [[path, a, b]], same_trajectory, first_difference_s, runs: {key: [a, b]},\n"
      "readouts: [[name, a, b]]}; of scenarios the first three. The exit code is 0 whether they differ or not.");
  const auto a = std::make_shared<std::string>(), b = std::make_shared<std::string>();
  const auto json = std::make_shared<bool>(false);
  verb->add_option("A", *a, "Folder of a run, or a scenario file")->required();
  verb->add_option("B", *b, "The other")->required();
  verb->add_flag("--json", *json, "Print the comparison as JSON");
  verb->callback([=, &chosen] { chosen = [=] { return compare(*a, *b, *json); }; });
}

} // namespace matrigrate::apps
