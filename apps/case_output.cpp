#include "apps/case_output.hpp"

#include "apps/terminal.hpp"
#include "base/file.hpp"

#include <fmt/format.h>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

std::string number(double value) { return fmt::format("{:.5g}", value); }

std::string verdict(bool holds) {
  return holds ? coloured("holds", Colour::good, Stream::out) : coloured("does not hold", Colour::bad, Stream::out);
}

/// "at least " for a one-sided check, nothing otherwise.
std::string at_least(const validation::Check& c) { return c.sense == validation::Sense::at_least ? "at least " : ""; }

std::string wanted(const validation::Check& c) {
  if (c.sense == validation::Sense::at_least) return at_least(c) + number(c.expected);
  return fmt::format("{} within {}", number(c.expected), number(c.tolerance));
}

} // namespace

std::string to_text(const Outcome& outcome) {
  std::string text =
      fmt::format("{}: {}\n", coloured(outcome.which->name, Colour::strong, Stream::out), outcome.which->summary);
  if (!outcome.result)
    return text + fmt::format("  {} {}\n\n", coloured("stopped:", Colour::bad, Stream::out), outcome.failure);
  for (const validation::Check& check : outcome.result->checks)
    text += fmt::format("  {}\n    measured {}, expected {} ({}): {}\n", check.quantity, number(check.measured),
                        wanted(check), check.reason, verdict(check.holds()));
  for (const std::string& remark : outcome.result->remarks) text += fmt::format("  note: {}\n", remark);
  return text + fmt::format("  {}, {:.1f} s\n\n", verdict(outcome.holds()), outcome.wall_time);
}

Json to_json(const Outcome& outcome) {
  Json checks = Json::array();
  Json remarks = Json::array();
  if (outcome.result) {
    for (const validation::Check& c : outcome.result->checks)
      checks.push_back({{"quantity", c.quantity},
                        {"measured", c.measured},
                        {"expected", c.expected},
                        {"tolerance", c.tolerance},
                        {"sense", c.sense == validation::Sense::near ? "near" : "at_least"},
                        {"reason", c.reason},
                        {"holds", c.holds()}});
    remarks = outcome.result->remarks;
  }
  return {{"name", outcome.which->name}, {"summary", outcome.which->summary}, {"holds", outcome.holds()},
          {"failure", outcome.failure},  {"wall_time_s", outcome.wall_time},  {"checks", checks},
          {"remarks", remarks}};
}

io::PageSection to_section(const Outcome& outcome) {
  io::PageSection section;
  section.title = outcome.which->name;
  section.summary = outcome.which->summary;
  section.holds = outcome.holds();
  if (!outcome.result) {
    section.remarks.push_back("Stopped: " + outcome.failure);
    return section;
  }
  for (const validation::Check& c : outcome.result->checks)
    section.check_rows.push_back({c.quantity, number(c.measured), at_least(c) + number(c.expected),
                                  at_least(c).empty() ? number(c.tolerance) : "none", c.reason,
                                  io::verdict(c.holds())});
  section.remarks = outcome.result->remarks;
  section.figures = outcome.result->figures;
  return section;
}

void write_outcome(const Outcome& outcome, const std::filesystem::path& folder) {
  if (!outcome.result) return;
  const std::string& name = outcome.which->name;
  write_file(folder / (name + ".csv"), io::to_csv(outcome.result->table));
  bool first = true;
  for (const io::Figure& figure : outcome.result->figures) {
    write_file(folder / (first ? name + ".svg" : fmt::format("{}-{}.svg", name, figure.name)), figure.svg);
    first = false;
  }
}

} // namespace matrigrate::apps
