#include "claims/claims.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace matrigrate::study {

namespace {

std::string joined(const std::vector<std::string>& parts) { return fmt::format("{}", fmt::join(parts, "; ")); }

/// A column of a table: its name, and the key of claim_json() that it has.
struct Column {
  std::string name;
  std::string key;
};

/// A line per claim. @param of_editions  further columns, where a claim was judged by the second edition of the rules
std::string table(const std::vector<JudgedClaim>& claims, std::vector<Column> columns,
                  const std::vector<std::string>& of_editions) {
  if (std::ranges::any_of(claims, [](const JudgedClaim& c) { return c.second_edition.has_value(); }))
    for (const std::string& key : of_editions) columns.push_back({key, key});
  const auto line = [&](const auto& text_of) {
    std::vector<std::string> texts;
    for (const Column& column : columns) texts.push_back(text_of(column));
    return store::csv_line({texts.begin(), texts.end()});
  };
  std::string text = line([](const Column& column) { return column.name; });
  for (const JudgedClaim& c : claims) {
    const nlohmann::ordered_json values = claim_json(c);
    text += line([&](const Column& column) -> std::string {
      const auto value = values.find(column.key);
      if (value == values.end()) return "";
      return value->is_array() ? joined(*value) : value->get<std::string>();
    });
  }
  return text;
}

} // namespace

std::string why_not(const Finding& finding) {
  const bool told = finding.verdict == Verdict::does_not_hold || finding.verdict == Verdict::in_direction;
  return (told ? "not met: " : "") + joined(finding.unmet);
}

std::string bottom_line(const std::vector<JudgedClaim>& claims) {
  const auto count = [&](const auto& condition) { return std::ranges::count_if(claims, condition); };
  const auto holds = [](const JudgedClaim& c) { return c.finding.verdict == Verdict::holds; };
  std::vector<std::string> parts;
  for (const ClaimKind kind :
       {ClaimKind::calibration, ClaimKind::predicted, ClaimKind::verification, ClaimKind::experiment}) {
    const auto of_kind = [&](const JudgedClaim& c) { return c.kind == kind; };
    if (const auto all = count(of_kind); all > 0)
      parts.push_back(fmt::format("{} of {} {}", count([&](const JudgedClaim& c) { return of_kind(c) && holds(c); }),
                                  all, kind_name(kind)));
  }
  const auto of = [&](Verdict verdict) { return count([&](const auto& c) { return c.finding.verdict == verdict; }); };
  const auto more = [](auto n, const char* what) { return n > 0 ? fmt::format("; {} {}", n, what) : std::string(); };
  return fmt::format("{} of {} hold{}{}{}", count(holds), claims.size(),
                     parts.size() > 1 ? fmt::format(": {}", fmt::join(parts, ", ")) : "",
                     more(of(Verdict::in_direction), "more in direction"), more(of(Verdict::undecided), "undecided"));
}

std::string conditions_csv(const std::vector<JudgedClaim>& claims) {
  std::vector<Column> columns;
  for (const char* key : {"id", "sentence", "published", "ours", "statistic", "verdict", "caveat"})
    columns.push_back({key, key});
  return table(claims, columns, {"statistic_second_edition", "verdict_second_edition"});
}

std::string claims_csv(const std::vector<JudgedClaim>& claims) {
  std::vector<Column> columns{
      {"id", "id"}, {"kind", "kind"}, {"claim", "sentence"}, {"published", "published"}, {"ours", "brief"}};
  for (const char* key : {"verdict", "why_not", "verdict_in_larger_disc", "against", "caveat"})
    columns.push_back({key, key});
  return table(claims, columns, {"verdict_second_edition", "why_not_second_edition", "against_second_edition"});
}

nlohmann::ordered_json claim_json(const JudgedClaim& c) {
  nlohmann::ordered_json json{{"id", c.id},
                              {"sentence", c.sentence},
                              {"published", c.published},
                              {"ours", c.finding.ours},
                              {"statistic", c.finding.conditions},
                              {"verdict", to_string(c.finding.verdict)},
                              {"caveat", c.caveat},
                              {"kind", kind_name(c.kind)},
                              {"brief", c.finding.brief},
                              {"why_not", why_not(c.finding)},
                              {"verdict_in_larger_disc", c.in_larger_disc ? to_string(c.in_larger_disc->verdict) : ""},
                              {"against", c.finding.against}};
  if (!c.second_edition) return json;
  json["verdict_second_edition"] = to_string(c.second_edition->verdict);
  json["why_not_second_edition"] = why_not(*c.second_edition);
  json["against_second_edition"] = c.second_edition->against;
  json["statistic_second_edition"] = c.second_edition->conditions;
  return json;
}

} // namespace matrigrate::study
