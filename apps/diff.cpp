#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "run/difference.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

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
  const Json found = run::difference(a, b);
  json ? print_json(found) : print(text_of(found));
  return done;
}

} // namespace

void add_diff(CLI::App& app, Action& chosen) {
  CLI::App* verb =
      app.add_subcommand("diff", "Compare two runs or two scenarios: parameters, read-outs, first difference");
  verb->footer(
      "Each of A and B is the folder of a run or a scenario file. Of two runs it also compares version, status, "
      "read-outs\n"
      "and trajectory, and says from when on the tracks differ.\n"
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
