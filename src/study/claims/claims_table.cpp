#include "claims/claims.hpp"
#include "tables/row_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace matrigrate::study {

namespace {

std::string joined(const std::vector<std::string>& parts) { return fmt::format("{}", fmt::join(parts, "; ")); }

/// The verdict with runs in the larger disc, where there are any.
std::string in_larger_disc(const JudgedClaim& c) {
  return c.in_larger_disc ? to_string(c.in_larger_disc->verdict) : "";
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

using View = std::string_view;

std::string conditions_csv(const std::vector<JudgedClaim>& claims) {
  std::string text = "id,sentence,published,ours,statistic,verdict,caveat\n";
  for (const JudgedClaim& c : claims)
    text += store::csv_line({View(c.id), View(c.sentence), View(c.published), View(joined(c.finding.ours)),
                             View(joined(c.finding.conditions)), View(to_string(c.finding.verdict)), View(c.caveat)});
  return text;
}

std::string claims_csv(const std::vector<JudgedClaim>& claims) {
  std::string text = "id,kind,claim,published,ours,verdict,why_not,verdict_in_larger_disc,against,caveat\n";
  for (const JudgedClaim& c : claims)
    text += store::csv_line({View(c.id), View(kind_name(c.kind)), View(c.sentence), View(c.published),
                             View(c.finding.brief), View(to_string(c.finding.verdict)), View(why_not(c.finding)),
                             View(in_larger_disc(c)), View(joined(c.finding.against)), View(c.caveat)});
  return text;
}

nlohmann::ordered_json claim_json(const JudgedClaim& c) {
  return {{"id", c.id},
          {"sentence", c.sentence},
          {"published", c.published},
          {"ours", c.finding.ours},
          {"statistic", c.finding.conditions},
          {"verdict", to_string(c.finding.verdict)},
          {"caveat", c.caveat},
          {"kind", kind_name(c.kind)},
          {"brief", c.finding.brief},
          {"why_not", why_not(c.finding)},
          {"verdict_in_larger_disc", in_larger_disc(c)},
          {"against", c.finding.against}};
}

} // namespace matrigrate::study
