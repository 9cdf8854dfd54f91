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

void add_rows(const std::vector<validation::Check>& checks, std::string_view prefix, report::PageSection& section) {
  for (const validation::Check& c : checks)
    section.check_rows.push_back(
        {fmt::format("{}{}", prefix, c.quantity), number(c.measured), bound_word(c) + number(c.expected),
         c.sense == validation::Sense::near ? number(c.tolerance) : "none", c.reason, report::verdict(c.holds())});
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

report::PageSection to_section(const Outcome& outcome) {
  report::PageSection section;
  section.title = outcome.which->name;
  section.summary = outcome.which->summary;
  section.holds = outcome.holds();
  if (!outcome.result) {
    section.remarks.push_back("Stopped: " + outcome.failure);
    return section;
  }
  add_rows(outcome.result->checks, "", section);
  add_rows(outcome.result->claims, "The paper's claim: ", section);
  section.remarks = outcome.result->claim_notes;
  section.remarks.insert(section.remarks.end(), outcome.result->remarks.begin(), outcome.result->remarks.end());
  section.figures = outcome.result->figures;
  return section;
}

void write_outcome(const Outcome& outcome, const std::filesystem::path& folder) {
  if (!outcome.result) return;
  const std::string& name = outcome.which->name;
  write_file(folder / (name + ".csv"), store::to_csv(outcome.result->table));
  bool first = true;
  for (const draw::Figure& figure : outcome.result->figures) {
    write_file(folder / (first ? name + ".svg" : fmt::format("{}-{}.svg", name, figure.name)), figure.svg);
    first = false;
  }
}

} // namespace matrigrate::apps
