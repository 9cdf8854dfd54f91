#include "apps/case_output.hpp"

#include "apps/terminal/terminal.hpp"
#include "base/file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

std::string number(double value) { return fmt::format("{:.5g}", value); }

std::string verdict(bool holds) {
  return holds ? coloured("holds", Colour::good, Stream::out) : coloured("does not hold", Colour::bad, Stream::out);
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

report::Statement to_statement(const Outcome& outcome) {
  const std::string& name = outcome.which->name;
  report::Statement statement{
      .id = name, .sentence = outcome.which->summary, .verdict = outcome.holds() ? "holds" : "fails", .published = {}};
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

void write_outcome(const Outcome& outcome, const std::filesystem::path& folder) {
  if (!outcome.result) return;
  const std::string& name = outcome.which->name;
  write_file(folder / (name + ".csv"), store::to_csv(outcome.result->table));
  for (const draw::Picture& picture : outcome.result->pictures)
    write_file(folder / fmt::format("{}-{}.svg", name, picture.name), picture.svg);
}

} // namespace matrigrate::apps
