#include "claims/claims.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace matrigrate::study {

namespace {

std::string joined(const std::vector<std::string>& parts) { return fmt::format("{}", fmt::join(parts, "; ")); }

using Json = nlohmann::ordered_json;

/// A value of a claim, by its key in JSON and its name in each table; no name where the table leaves it out.
struct Column {
  const char* key;
  const char* in_claims;
  const char* in_conditions;
  Json (*value)(const JudgedClaim& c);
  bool of_second_edition = false; ///< of a claim that was judged by the second edition of the rules as well
};

constexpr Column columns[] = {
    {"id", "id", "id", [](const JudgedClaim& c) -> Json { return c.id; }},
    {"kind", "kind", nullptr, [](const JudgedClaim& c) -> Json { return kind_name(c.kind); }},
    {"sentence", "claim", "sentence", [](const JudgedClaim& c) -> Json { return c.sentence; }},
    {"published", "published", "published", [](const JudgedClaim& c) -> Json { return c.published; }},
    {"brief", "ours", nullptr, [](const JudgedClaim& c) -> Json { return c.finding.brief; }},
    {"ours", nullptr, "ours", [](const JudgedClaim& c) -> Json { return c.finding.ours; }},
    {"statistic", nullptr, "statistic", [](const JudgedClaim& c) -> Json { return c.finding.conditions; }},
    {"verdict", "verdict", "verdict", [](const JudgedClaim& c) -> Json { return to_string(c.finding.verdict); }},
    {"why_not", "why_not", nullptr, [](const JudgedClaim& c) -> Json { return why_not(c.finding); }},
    {"verdict_in_larger_disc", "verdict_in_larger_disc", nullptr,
     [](const JudgedClaim& c) -> Json { return c.in_larger_disc ? to_string(c.in_larger_disc->verdict) : ""; }},
    {"against", "against", nullptr, [](const JudgedClaim& c) -> Json { return c.finding.against; }},
    {"caveat", "caveat", "caveat", [](const JudgedClaim& c) -> Json { return c.caveat; }},
    {"statistic_second_edition", nullptr, "statistic_second_edition",
     [](const JudgedClaim& c) -> Json { return c.second_edition->conditions; }, true},
    {"verdict_second_edition", "verdict_second_edition", "verdict_second_edition",
     [](const JudgedClaim& c) -> Json { return to_string(c.second_edition->verdict); }, true},
    {"why_not_second_edition", "why_not_second_edition", nullptr,
     [](const JudgedClaim& c) -> Json { return why_not(*c.second_edition); }, true},
    {"against_second_edition", "against_second_edition", nullptr,
     [](const JudgedClaim& c) -> Json { return c.second_edition->against; }, true},
};

/// A line per claim. @param name  of a column in this table
std::string table(const std::vector<JudgedClaim>& claims, const char* Column::*name) {
  const bool editions = std::ranges::any_of(claims, [](const JudgedClaim& c) { return c.second_edition.has_value(); });
  const auto line = [&](const auto& text_of) {
    std::vector<std::string> texts;
    for (const Column& column : columns)
      if (column.*name != nullptr && (editions || !column.of_second_edition)) texts.push_back(text_of(column));
    return store::csv_line({texts.begin(), texts.end()});
  };
  std::string text = line([&](const Column& column) -> std::string { return column.*name; });
  for (const JudgedClaim& c : claims)
    text += line([&](const Column& column) -> std::string {
      if (column.of_second_edition && !c.second_edition) return "";
      const Json value = column.value(c);
      return value.is_array() ? joined(value) : value.get<std::string>();
    });
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

std::string conditions_csv(const std::vector<JudgedClaim>& claims) { return table(claims, &Column::in_conditions); }

std::string claims_csv(const std::vector<JudgedClaim>& claims) { return table(claims, &Column::in_claims); }

Json claims_json(const std::vector<JudgedClaim>& claims) {
  Json list = Json::array();
  for (const JudgedClaim& c : claims) {
    Json& json = list.emplace_back(Json::object());
    for (const Column& column : columns)
      if (c.second_edition || !column.of_second_edition) json[column.key] = column.value(c);
  }
  return list;
}

} // namespace matrigrate::study
