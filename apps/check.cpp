#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "claims/claims.hpp"
#include "parameters/changes.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/read.hpp"
#include "parameters/version.hpp"
#include "run/estimate.hpp"
#include "simulation/start.hpp"
#include "study_plan/read_study.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <utility>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

struct CheckArguments {
  std::vector<std::string> files;
  std::vector<std::string> overrides;
  bool json = false;
};

/// The kind of a file, and its faults.
struct Finding {
  std::string file;
  bool study = false;
  std::string size;               ///< of a good study: "4 points x 2 replicates = 8 runs"
  std::string closures;           ///< the set that a good file belongs to
  bool noted = false;             ///< whether a note says it
  std::vector<std::string> notes; ///< on closures and model; on the measured tracks of a study; what the steps of a
                                  ///< scenario cost, and which of its outputs are uneven
  std::vector<Fault> faults;      ///< none if it is good
  std::string unreadable;         ///< why it cannot be read; empty if it can
};

/// The set of closures of a scenario or of the base of a study, and what to know about them and about the model.
void look_at_model(const Parameters& p, Finding& found) {
  const Closures closures = closures_of(p);
  found.closures = closures.text;
  found.noted = !closures.note.empty();
  for (const std::string& note : {closures.note, run::note_of_scenario(p), run::note_of_drag(p)})
    if (!note.empty()) found.notes.push_back(note);
  for (std::string& note : law_notes(p)) found.notes.push_back(std::move(note));
  for (const ChangeWords& change : words_of_changes(p)) found.notes.push_back(to_text(change));
}

Finding look_at(const std::string& file, const std::vector<std::string>& overrides) {
  Finding found;
  found.file = file;
  try {
    found.study = study::is_study_file(file);
    if (found.study) {
      const study::Study s =
          study::read_study(file, {.overrides = overrides,
                                   .replicates = {},
                                   .more = start_rules(),
                                   .labels_of = study::other_studies(std::filesystem::path(file).parent_path())});
      for (const study::Target& target : s.targets)
        found.notes.insert(found.notes.end(), target.notes.begin(), target.notes.end());
      look_at_model(s.base, found);
      found.size = fmt::format("{} points x {} replicates = {} runs", s.points.size(), s.replicates, s.runs());
    } else {
      const Parameters p = read_parameters(file, overrides, start_rules());
      look_at_model(p, found);
      for (std::string& note : run::uneven_outputs(p)) found.notes.push_back(std::move(note));
      for (std::string note : {run::fault_of_bias(p), run::cost_of_reference_steps(p)})
        if (!note.empty()) found.notes.push_back(std::move(note));
    }
  } catch (const ConfigurationError& error) {
    found.faults = error.faults();
  } catch (const InputOutputError& error) {
    found.unreadable = error.what();
  }
  return found;
}

Json to_json(const Finding& found) {
  Json list = Json::array();
  for (const Fault& fault : found.faults)
    list.push_back({{"line", fault.line}, {"column", fault.column}, {"key", fault.key}, {"message", fault.message}});
  if (!found.unreadable.empty())
    list.push_back({{"line", 0}, {"column", 0}, {"key", ""}, {"message", found.unreadable}});
  return {{"file", found.file},   {"kind", found.study ? "study" : "scenario"},
          {"good", list.empty()}, {"closures", found.closures.empty() ? Json() : Json(found.closures)},
          {"notes", found.notes}, {"faults", list}};
}

void print_finding(const Finding& found) {
  print_faults(found.faults);
  if (!found.unreadable.empty()) return print_error(found.unreadable + "\n");
  if (!found.faults.empty()) return;
  print(fmt::format("{}: {}{}\n", found.file, coloured("good", Colour::good, Stream::out),
                    found.study ? " study: " + found.size : ""));
  if (!found.noted && found.closures != closures_of({}).text)
    print(fmt::format("{}: closures: {}\n", found.file, found.closures));
  for (const std::string& note : found.notes) print(fmt::format("{}: {}\n", found.file, note));
}

int check_files(const CheckArguments& options) {
  int code = done;
  Json files = Json::array();
  for (const std::string& file : options.files) {
    const Finding found = look_at(file, options.overrides);
    if (!found.faults.empty()) code = std::max<int>(code, configuration);
    if (!found.unreadable.empty()) code = input_output;
    if (options.json)
      files.push_back(to_json(found));
    else
      print_finding(found);
  }
  if (options.json) print_json({{"good", code == done}, {"files", files}});
  return code;
}

} // namespace

void add_check(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("check", "Validate scenarios and studies; print every fault at once");
  verb->footer(
      "A fault is printed as file:line:column: key: what is wrong and what is allowed. Of a file that is not TOML the\n"
      "first error is printed.\n"
      "A good file is followed by notes, and by the set of closures that it belongs to where that is not the third.\n"
      "--json prints {good, files: [{file, kind, good, closures, notes, faults: [{line, column, key, message}]}]};\n"
      "line and column are 0 where there is none. Exit code 3 if any file has a fault, 5 if one cannot be read.");
  const auto options = std::make_shared<CheckArguments>();
  verb->add_option("FILE", options->files, "Scenario and study files")->required();
  verb->add_option("--set", options->overrides, "key=value, over the files; may be repeated")->allow_extra_args(false);
  verb->add_flag("--json", options->json, "Print the findings as JSON");
  verb->callback([options, &chosen] { chosen = [options] { return check_files(*options); }; });
}

} // namespace matrigrate::apps
