#include "apps/case_output.hpp"
#include "apps/shipped_pages.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/threads.hpp"
#include "parameters/nearest.hpp"
#include "parameters/read.hpp"
#include "parameters/write.hpp"
#include "run/provenance.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <memory>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

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

Outcome outcome_of(const validation::Case& c, const Parameters& p) {
  Outcome outcome;
  outcome.which = &c;
  const auto start = std::chrono::steady_clock::now();
  try {
    outcome.result = validation::run_case(c, p);
  } catch (const NumericalFailure& failure) {
    outcome.failure = failure.what();
  }
  outcome.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

void write_report(const ValidateArguments& options, const std::vector<Outcome>& outcomes) {
  report::VerdictReport report{.title = fmt::format("Validation of the matrix: {}", options.name),
                               .statements = {},
                               .provenance = provenance_text()};
  for (const Outcome& outcome : outcomes) report.statements.push_back(to_statement(outcome));
  write_file(std::filesystem::path(options.folder) / "report.html",
             report::filled_page(verdicts_page_template(), report::verdict_data(report)));
}

std::string results_json(const ValidateArguments& options, const std::vector<Outcome>& outcomes) {
  Json cases = Json::array();
  for (const Outcome& outcome : outcomes) cases.push_back(to_json(outcome));
  const Json all{{"folder", options.folder},
                 {"holds", std::ranges::all_of(outcomes, &Outcome::holds)},
                 {"cases", cases},
                 {"provenance", provenance()}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string verdict_line(const ValidateArguments& options, const std::vector<Outcome>& outcomes) {
  return fmt::format("{} of {} {}; report: {}/report.html\n", std::ranges::count_if(outcomes, &Outcome::holds),
                     outcomes.size(), outcomes.size() == 1 ? "case holds" : "cases hold", options.folder);
}

int validate(ValidateArguments options) {
  const auto chosen = chosen_cases(options.name);
  const Parameters p = options.scenario.empty() ? apply_overrides(validation::default_parameters(), options.overrides)
                                                : read_parameters(options.scenario, options.overrides);
  if (options.folder.empty()) options.folder = "validate-" + options.name;
  make_output_folder(options.folder, options.force);
  write_file(std::filesystem::path(options.folder) / "scenario.resolved.toml", to_toml(p));
  const ThreadLimit limit(p.run.threads);

  std::vector<Outcome> outcomes;
  for (const validation::Case* c : chosen) {
    outcomes.push_back(outcome_of(*c, p));
    write_outcome(outcomes.back(), options.folder);
    if (options.json || options.quiet) continue;
    print(to_text(outcomes.back()));
    flush(); // a case may take minutes
  }
  write_report(options, outcomes);
  const std::string results = results_json(options, outcomes);
  write_file(std::filesystem::path(options.folder) / "results.json", results);
  print(options.json ? results : verdict_line(options, outcomes));
  return std::ranges::all_of(outcomes, &Outcome::holds) ? done : numerical;
}

} // namespace

void add_validate(CLI::App& app, Action& chosen) {
  CLI::App* verb =
      app.add_subcommand("validate", "Verify the matrix on its own against closed forms and measured limits");
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
