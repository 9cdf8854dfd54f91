#include "apps/shipped_pages.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/nearest.hpp"
#include "parameters/read.hpp"
#include "parameters/write.hpp"
#include "report/verdict_page.hpp"
#include "run/folder_state.hpp"
#include "run/provenance.hpp"
#include "simulation/start.hpp"
#include "validation/case.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
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

/// How a case ended: with a result, or with the reason why there is none.
struct Outcome {
  const validation::Case* which;
  validation::Result result; ///< an empty one, which does not hold, if there is none
  std::string failure;       ///< empty if there is a result
  double wall_time = 0.0;    ///< [s]
};

bool holds(const Outcome& outcome) { return outcome.result.holds(); }

std::string number(double value) { return fmt::format("{:.5g}", value); }

report::Verdict verdict_of(bool holds) { return holds ? report::Verdict::holds : report::Verdict::does_not_hold; }

std::string verdict(bool holds) {
  return coloured(to_string(verdict_of(holds)), holds ? Colour::good : Colour::bad, Stream::out);
}

std::string lines(const std::vector<validation::Check>& checks) {
  std::string text;
  for (const validation::Check& c : checks) {
    const std::string wanted =
        c.sense == validation::Sense::near
            ? fmt::format("{} within {}", number(c.expected), number(c.tolerance))
            : fmt::format("{} {}", c.sense == validation::Sense::at_least ? "at least" : "at most", number(c.expected));
    text += fmt::format("  {}\n    measured {}, expected {} ({}): {}\n", c.quantity, number(c.measured), wanted,
                        c.reason, verdict(c.holds()));
  }
  return text;
}

/// Measured beside expected, tolerance and its reason, verdict; for a terminal.
std::string to_text(const Outcome& outcome) {
  std::string text =
      fmt::format("{}: {}\n", coloured(outcome.which->name, Colour::strong, Stream::out), outcome.which->summary);
  if (!outcome.failure.empty())
    return text + fmt::format("  {} {}\n\n", coloured("stopped:", Colour::bad, Stream::out), outcome.failure);
  const validation::Result& result = outcome.result;
  text += lines(result.checks);
  if (!result.claims.empty()) text += "  The paper's claims:\n" + lines(result.claims);
  for (const std::string& note : result.claim_notes) text += fmt::format("  note on the claims: {}\n", note);
  for (const std::string& remark : result.remarks) text += fmt::format("  note: {}\n", remark);
  return text + fmt::format("  {}, {:.1f} s\n\n", verdict(holds(outcome)), outcome.wall_time);
}

Json rows(const std::vector<validation::Check>& checks) {
  Json all = Json::array();
  for (const validation::Check& c : checks) {
    constexpr std::array senses{"near", "at_least", "at_most"};
    all.push_back({{"quantity", c.quantity},
                   {"measured", c.measured},
                   {"expected", c.expected},
                   {"tolerance", c.tolerance},
                   {"sense", senses.at(static_cast<std::size_t>(c.sense))},
                   {"reason", c.reason},
                   {"holds", c.holds()}});
  }
  return all;
}

/// results.json.
std::string results_json(const std::string& folder, const std::vector<Outcome>& outcomes) {
  Json cases = Json::array();
  for (const auto& [which, result, failure, wall_time] : outcomes)
    cases.push_back({{"name", which->name},
                     {"summary", which->summary},
                     {"holds", result.holds()},
                     {"failure", failure},
                     {"wall_time_s", wall_time},
                     {"checks", rows(result.checks)},
                     {"claims", rows(result.claims)},
                     {"claim_notes", result.claim_notes},
                     {"remarks", result.remarks}});
  const Json all{{"folder", folder},
                 {"holds", std::ranges::all_of(outcomes, holds)},
                 {"cases", cases},
                 {"provenance", run::provenance()}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The chapter of the report.
report::Statement to_statement(const Outcome& outcome) {
  const std::string& name = outcome.which->name;
  const validation::Result& result = outcome.result;
  report::Statement statement{
      .id = name, .sentence = outcome.which->summary, .verdict = verdict_of(holds(outcome)), .published = {}};
  if (!outcome.failure.empty()) {
    statement.details = {{"Stopped", {outcome.failure}}};
    return statement;
  }
  statement.checks = rows(result.checks);
  statement.claims = rows(result.claims);
  statement.details = {{"Notes on the claims", result.claim_notes}, {"Remarks", result.remarks}};
  statement.plots = result.plots;
  for (report::Plot& plot : statement.plots)
    if (plot.name != name) plot.name = fmt::format("{}-{}", name, plot.name);
  statement.pictures = result.pictures;
  return statement;
}

Outcome outcome_of(const validation::Case& c, const Parameters& p) {
  Outcome outcome{.which = &c, .result = {}, .failure = {}};
  const auto start = std::chrono::steady_clock::now();
  try {
    outcome.result = validation::run_case(c, p);
  } catch (const NumericalFailure& failure) {
    outcome.failure = failure.what();
  }
  outcome.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

/// NAME.csv, and NAME-<picture>.svg of each picture; nothing if there is no result.
void write_outcome(const Outcome& outcome, const std::filesystem::path& folder) {
  if (!outcome.failure.empty()) return;
  const std::string& name = outcome.which->name;
  write_file(folder / (name + ".csv"), store::to_csv(outcome.result.table));
  for (const draw::Picture& picture : outcome.result.pictures)
    write_file(folder / fmt::format("{}-{}.svg", name, picture.name), picture.svg);
}

/// Runs cases, and writes what they come to into the folder: files of each as it ends, then report.html and
/// results.json.
std::vector<Outcome> run_cases(const ValidateArguments& options, const std::vector<const validation::Case*>& chosen,
                               const Parameters& p) {
  const std::filesystem::path folder = options.folder;
  write_file(folder / "scenario.resolved.toml", to_toml(p));
  const ThreadLimit limit(std::max(1, p.run.threads));
  std::vector<Outcome> outcomes;
  report::VerdictReport report{.title = fmt::format("Validation of the matrix: {}", options.name),
                               .statements = {},
                               .provenance = run::provenance_text()};
  for (const validation::Case* c : chosen) {
    const Outcome& outcome = outcomes.emplace_back(outcome_of(*c, p));
    write_outcome(outcome, folder);
    report.statements.push_back(to_statement(outcome));
    if (options.json || options.quiet) continue;
    print(to_text(outcome));
    flush(); // a case may take minutes
  }
  write_file(folder / "report.html", report::filled_page(verdicts_page_template(), report::verdict_data(report)));
  write_file(folder / "results.json", results_json(options.folder, outcomes));
  return outcomes;
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
  const std::vector<Outcome> outcomes = run_cases(options, chosen, p);
  if (options.json)
    print(results_json(options.folder, outcomes));
  else
    print(fmt::format("{} of {} {}; report: {}/report.html\n", std::ranges::count_if(outcomes, holds), outcomes.size(),
                      outcomes.size() == 1 ? "case holds" : "cases hold", options.folder));
  return std::ranges::all_of(outcomes, holds) ? done : numerical;
}

} // namespace

void add_validate(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("validate", "Verify parts of the model against closed forms and measured limits");
  verb->footer(
      "Writes NAME.csv, pictures of particles NAME-<picture>.svg, scenario.resolved.toml, report.html with all "
      "figures\n"
      "and results.json, which --json prints as well: {folder, holds, cases: [{name, summary, holds, failure, "
      "wall_time_s, checks: [{quantity,\n"
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
