#include "claims/claims.hpp"
#include "store/row_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::study {

std::string why_not(const Finding& finding) {
  return fmt::format("{}{}", finding.verdict == Verdict::does_not_hold ? "not met: " : "",
                     fmt::join(finding.unmet, "; "));
}

std::string second_bottom_line(const std::vector<JudgedClaim>& claims) {
  const auto count = [&](Verdict verdict) {
    return std::ranges::count_if(claims, [&](const JudgedClaim& c) { return c.finding.second == verdict; });
  };
  return fmt::format("{} of {} hold and {} more are in direction by the second edition of the rules",
                     count(Verdict::holds), claims.size(), count(Verdict::in_direction));
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
  const auto undecided = count([](const JudgedClaim& c) { return c.finding.verdict == Verdict::undecided; });
  return fmt::format("{} of {} hold{}{}", count(holds), claims.size(),
                     parts.size() > 1 ? fmt::format(": {}", fmt::join(parts, ", ")) : "",
                     undecided > 0 ? fmt::format("; {} undecided", undecided) : "");
}

namespace {

/// "holds", and beside it the second verdict where there is one.
std::string verdict_text(const JudgedClaim& c) {
  return to_string(c.finding.verdict)
         + (c.in_larger_disc ? fmt::format(" (larger disc: {})", to_string(c.in_larger_disc->verdict)) : "");
}

} // namespace

std::string markdown_table(const std::vector<JudgedClaim>& claims) {
  std::string text =
      "| row | kind | claim | published | ours: mean [95 % interval] | verdict | second edition | why not |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const JudgedClaim& c : claims)
    text += fmt::format("| {} | {} | {} | {} | {} | **{}** | {} | {} |\n", c.id, kind_name(c.kind), c.sentence,
                        c.published, c.finding.brief, verdict_text(c), to_string(c.finding.second), why_not(c.finding));
  return text;
}

using View = std::string_view;

std::string conditions_csv(const std::vector<JudgedClaim>& claims) {
  std::string text = store::csv_line({View("id"), View("sentence"), View("published"), View("ours"), View("statistic"),
                                      View("verdict"), View("caveat")});
  for (const JudgedClaim& row : claims) {
    const std::string verdict = to_string(row.finding.verdict);
    const std::string ours = fmt::format("{}", fmt::join(row.finding.ours, "; "));
    const std::string statistic = fmt::format("{}", fmt::join(row.finding.conditions, "; "));
    text += store::csv_line({View(row.id), View(row.sentence), View(row.published), View(ours), View(statistic),
                             View(verdict), View(row.caveat)});
  }
  return text;
}

std::string claims_csv(const std::vector<JudgedClaim>& claims) {
  std::string text = store::csv_line({View("id"), View("kind"), View("claim"), View("published"), View("ours"),
                                      View("verdict"), View("why_not"), View("verdict_in_larger_disc"),
                                      View("verdict_second_edition"), View("caveat")});
  for (const JudgedClaim& row : claims) {
    const std::string kind = kind_name(row.kind);
    const std::string verdict = to_string(row.finding.verdict);
    const std::string why = why_not(row.finding);
    const std::string larger = row.in_larger_disc ? to_string(row.in_larger_disc->verdict) : "";
    const std::string second = to_string(row.finding.second);
    text += store::csv_line({View(row.id), View(kind), View(row.sentence), View(row.published), View(row.finding.brief),
                             View(verdict), View(why), View(larger), View(second), View(row.caveat)});
  }
  return text;
}

} // namespace matrigrate::study
