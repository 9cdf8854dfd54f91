#include "apps/case_output.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/nearest.hpp"
#include "parameters/read.hpp"
#include "run/folder_state.hpp"
#include "simulation/start.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace matrigrate::apps {

namespace {

struct ValidateArguments {
  std::string name;
  std::string folder;
  std::string scenario;
  std::vector<std::string> overrides;
  bool force = false;
  bool json = false;
  bool quiet = false;
};

std::vector<const validation::Case*> chosen_cases(const std::string& name) {
  std::vector<const validation::Case*> chosen;
  std::vector<std::string> names{"all"};
  for (const validation::Case& c : validation::cases()) {
    names.push_back(c.name);
    if (name == c.name || name == "all") chosen.push_back(&c);
  }
  if (chosen.empty())
    throw UsageError(fmt::format("there is no case \"{}\"{}\nThe cases are: {}", name,
                                 did_you_mean(nearest(name, names)), fmt::join(names, ", ")));
  return chosen;
}

std::string verdict_line(const ValidateArguments& options, const std::vector<Outcome>& outcomes) {
  return fmt::format("{} of {} {}; report: {}/report.html\n", std::ranges::count_if(outcomes, &Outcome::holds),
                     outcomes.size(), outcomes.size() == 1 ? "case holds" : "cases hold", options.folder);
}

int validate(ValidateArguments options) {
  const auto chosen = chosen_cases(options.name);
  const Parameters p = options.scenario.empty()
                           ? apply_overrides(validation::default_parameters(), options.overrides, formula_rules())
                           : read_parameters(options.scenario, options.overrides, formula_rules());
  for (const auto* one : chosen)
    if (one->name == "disassembly" && is_changed(*find_row("laws.disassembly_rate"), p))
      throw ConfigurationError(
          {{"", 0, 0, "laws.disassembly_rate", "the case disassembly is of Eq. 7, and takes no other law"}});
  if (options.folder.empty()) options.folder = "validate-" + options.name;
  if (!options.force) require(run::look_at(options.folder), run::Use::results);
  make_folder(options.folder);
  const std::vector<Outcome> outcomes = run_cases(chosen, options.name, p, options.folder, [&](const Outcome& outcome) {
    if (options.json || options.quiet) return;
    print(to_text(outcome));
    flush(); // a case may take minutes
  });
  print(options.json ? results_json(options.folder, outcomes) : verdict_line(options, outcomes));
  return std::ranges::all_of(outcomes, &Outcome::holds) ? done : numerical;
}

} // namespace

void add_validate(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("validate", "Verify parts of the model against closed forms and measured limits");
  verb->footer(
      "Writes NAME.csv, pictures of particles NAME-<picture>.svg, scenario.resolved.toml, report.html with all "
      "figures\n"
      "and results.json, which --json prints as well: {folder, holds, cases: [{name, summary, holds, failure, "
      "wall_time_s, "
      "checks: [{quantity,\n"
      "measured, expected, tolerance, sense, reason, holds}], claims: [as checks], claim_notes, remarks}], "
      "provenance}.\n"
      "A case holds if its checks do: the program does what its equations say. What the paper claims of fibres,\n"
      "fibres-uniaxial and disassembly is judged beside it (matrigrate reproduce V).\n"
      "Exit code 4 if a case does not hold or stops with a numerical failure.");
  const auto options = std::make_shared<ValidateArguments>();
  verb->add_option("NAME", options->name, "A case of `matrigrate list`, or all")->required();
  verb->add_option("-o,--output", options->folder, "Folder for the results (default: validate-NAME)");
  verb->add_option("--scenario", options->scenario, "Take material and numerics from this scenario file");
  verb->add_option("--set", options->overrides, "key=value, over the scenario; may be repeated")
      ->allow_extra_args(false);
  verb->add_flag("--force", options->force,
                 "Write into a folder that is not empty: files of the same name are replaced, others are kept");
  verb->add_flag("--json", options->json, "Print the results as JSON");
  verb->add_flag("--quiet", options->quiet, "Print only the verdict");
  verb->callback([options, &chosen] { chosen = [options] { return validate(*options); }; });
}

} // namespace matrigrate::apps
