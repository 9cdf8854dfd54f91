#include "apps/case_output.hpp"

#include "apps/shipped_pages.hpp"
#include "apps/terminal/terminal.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "parameters/write.hpp"
#include "run/provenance.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

std::string number(double value) { return fmt::format("{:.5g}", value); }

report::Verdict verdict_of(bool holds) { return holds ? report::Verdict::holds : report::Verdict::does_not_hold; }

std::string verdict(bool holds) {
  return coloured(to_string(verdict_of(holds)), holds ? Colour::good : Colour::bad, Stream::out);
}

/// "at least " or "at most " for a one-sided check, nothing otherwise.
std::string bound_word(const validation::Check& c) {
  switch (c.sense) {
  case validation::Sense::at_least:
    return "at least ";
  case validation::Sense::at_most:
    return "at most ";
  case validation::Sense::near:
    break;
  }
  return "";
}

std::string wanted(const validation::Check& c) {
  if (c.sense != validation::Sense::near) return bound_word(c) + number(c.expected);
  return fmt::format("{} within {}", number(c.expected), number(c.tolerance));
}

std::string lines(const std::vector<validation::Check>& checks) {
  std::string text;
  for (const validation::Check& check : checks)
    text += fmt::format("  {}\n    measured {}, expected {} ({}): {}\n", check.quantity, number(check.measured),
                        wanted(check), check.reason, verdict(check.holds()));
  return text;
}

Json rows(const std::vector<validation::Check>& checks) {
  Json all = Json::array();
  for (const validation::Check& c : checks) {
    const char* sense = c.sense == validation::Sense::near       ? "near"
                        : c.sense == validation::Sense::at_least ? "at_least"
                                                                 : "at_most";
    all.push_back({{"quantity", c.quantity},
                   {"measured", c.measured},
                   {"expected", c.expected},
                   {"tolerance", c.tolerance},
                   {"sense", sense},
                   {"reason", c.reason},
                   {"holds", c.holds()}});
  }
  return all;
}

} // namespace

std::string to_text(const Outcome& outcome) {
  std::string text =
      fmt::format("{}: {}\n", coloured(outcome.which->name, Colour::strong, Stream::out), outcome.which->summary);
  if (!outcome.result)
    return text + fmt::format("  {} {}\n\n", coloured("stopped:", Colour::bad, Stream::out), outcome.failure);
  text += lines(outcome.result->checks);
  if (!outcome.result->claims.empty()) text += "  The paper's claims:\n" + lines(outcome.result->claims);
  for (const std::string& note : outcome.result->claim_notes) text += fmt::format("  note on the claims: {}\n", note);
  for (const std::string& remark : outcome.result->remarks) text += fmt::format("  note: {}\n", remark);
  return text + fmt::format("  {}, {:.1f} s\n\n", verdict(outcome.holds()), outcome.wall_time);
}

Json to_json(const Outcome& outcome) {
  const validation::Result none;
  const validation::Result& result = outcome.result ? *outcome.result : none;
  return {{"name", outcome.which->name},   {"summary", outcome.which->summary}, {"holds", outcome.holds()},
          {"failure", outcome.failure},    {"wall_time_s", outcome.wall_time},  {"checks", rows(result.checks)},
          {"claims", rows(result.claims)}, {"claim_notes", result.claim_notes}, {"remarks", result.remarks}};
}

namespace {

/// The chapter of the report.
report::Statement to_statement(const Outcome& outcome) {
  const std::string& name = outcome.which->name;
  report::Statement statement{
      .id = name, .sentence = outcome.which->summary, .verdict = verdict_of(outcome.holds()), .published = {}};
  if (!outcome.result) {
    statement.details = {{"Stopped", {outcome.failure}}};
    return statement;
  }
  statement.checks = rows(outcome.result->checks);
  statement.claims = rows(outcome.result->claims);
  statement.details = {{"Notes on the claims", outcome.result->claim_notes}, {"Remarks", outcome.result->remarks}};
  statement.plots = outcome.result->plots;
  for (report::Plot& plot : statement.plots)
    if (plot.name != name) plot.name = fmt::format("{}-{}", name, plot.name);
  statement.pictures = outcome.result->pictures;
  return statement;
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

/// NAME.csv, and NAME-<picture>.svg of each picture; nothing if there is no result.
void write_outcome(const Outcome& outcome, const std::filesystem::path& folder) {
  if (!outcome.result) return;
  const std::string& name = outcome.which->name;
  write_file(folder / (name + ".csv"), store::to_csv(outcome.result->table));
  for (const draw::Picture& picture : outcome.result->pictures)
    write_file(folder / fmt::format("{}-{}.svg", name, picture.name), picture.svg);
}

} // namespace

std::string results_json(const std::filesystem::path& folder, const std::vector<Outcome>& outcomes) {
  Json cases = Json::array();
  for (const Outcome& outcome : outcomes) cases.push_back(to_json(outcome));
  const Json all{{"folder", folder.string()},
                 {"holds", std::ranges::all_of(outcomes, &Outcome::holds)},
                 {"cases", cases},
                 {"provenance", run::provenance()}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<Outcome> run_cases(const std::vector<const validation::Case*>& cases, std::string_view name,
                               const Parameters& p, const std::filesystem::path& folder,
                               const std::function<void(const Outcome&)>& shown) {
  write_file(folder / "scenario.resolved.toml", to_toml(p));
  const ThreadLimit limit(std::max(1, p.run.threads));
  std::vector<Outcome> outcomes;
  report::VerdictReport report{.title = fmt::format("Validation of the matrix: {}", name),
                               .statements = {},
                               .provenance = run::provenance_text()};
  for (const validation::Case* c : cases) {
    const Outcome& outcome = outcomes.emplace_back(outcome_of(*c, p));
    write_outcome(outcome, folder);
    report.statements.push_back(to_statement(outcome));
    shown(outcome);
  }
  write_file(folder / "report.html", report::filled_page(verdicts_page_template(), report::verdict_data(report)));
  write_file(folder / "results.json", results_json(folder, outcomes));
  return outcomes;
}

} // namespace matrigrate::apps
