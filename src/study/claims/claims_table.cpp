#include "claims/claims.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::study {

RowKind row_kind(std::string_view id, ClosureSet set) {
  if (id.starts_with('X')) return RowKind::experiment;
  if (id.starts_with('V') || id.starts_with('F')) return RowKind::verification;
  if (id.starts_with('E')) return set == ClosureSet::second ? RowKind::calibration : RowKind::predicted;
  return id.starts_with('D') || (id.starts_with('A') && id != "A8") ? RowKind::calibration : RowKind::predicted;
}

std::string to_string(RowKind kind) {
  switch (kind) {
  case RowKind::calibration:
    return "calibration";
  case RowKind::predicted:
    return "predicted";
  case RowKind::verification:
    return "verification";
  default:
    return "experiment";
  }
}

std::vector<Claim> all_claims() {
  std::vector<Claim> all(claims().begin(), claims().end());
  all.insert(all.end(), experiment_claims().begin(), experiment_claims().end());
  return all;
}

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
  for (const RowKind kind : {RowKind::calibration, RowKind::predicted, RowKind::verification, RowKind::experiment}) {
    const auto of_kind = [&](const JudgedClaim& c) { return c.kind == kind; };
    if (const auto all = count(of_kind); all > 0)
      parts.push_back(fmt::format("{} of {} {}", count([&](const JudgedClaim& c) { return of_kind(c) && holds(c); }),
                                  all, to_string(kind)));
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
    text += fmt::format("| {} | {} | {} | {} | {} | **{}** | {} | {} |\n", c.id, to_string(c.kind), c.sentence,
                        c.published, c.finding.brief, verdict_text(c), to_string(c.finding.second), why_not(c.finding));
  return text;
}

} // namespace matrigrate::study
