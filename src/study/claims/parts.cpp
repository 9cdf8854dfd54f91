#include "claims/parts.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/fields_shown.hpp"
#include "claims/study_claims.hpp"
#include "run/finished_run.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace matrigrate::study {

namespace {

using Json = nlohmann::ordered_json;
using validation::Check;
using validation::Sense;

constexpr std::size_t largest_file = std::size_t{1} << 24U;
constexpr double six_hours = 21600.0; // [s]

/// "within 0.1 of 1.2 (why)"
std::string wanted(const Check& claim) {
  const std::string bound = claim.sense == Sense::near       ? fmt::format("within {:.3g} of ", claim.tolerance)
                            : claim.sense == Sense::at_least ? "at least "
                                                             : "at most ";
  return fmt::format("{}{:.3g} ({})", bound, claim.expected, claim.reason);
}

Finding finding_of(const std::vector<Check>& claims, const std::vector<std::string>& notes, bool verified,
                   const std::filesystem::path& folder) {
  Finding finding;
  for (const Check& claim : claims) {
    const std::string measured = fmt::format("{}: {:.3g}", claim.quantity, claim.measured);
    finding.ours.push_back(measured);
    finding.conditions.push_back(fmt::format("{}: {}", wanted(claim), claim.holds() ? "met" : "not met"));
    if (!claim.holds()) finding.unmet.push_back(fmt::format("{}, wanted {}", measured, wanted(claim)));
  }
  finding.brief = fmt::format("{}", fmt::join(finding.ours, "; "));
  finding.ours.insert(finding.ours.end(), notes.begin(), notes.end());
  if (!verified) {
    finding.conditions.push_back(
        fmt::format("the verification itself does not hold: see {}", (folder / "report.html").string()));
    finding.unmet.emplace_back("the verification itself does not hold");
  }
  finding.verdict = !verified                                  ? Verdict::undecided
                    : finding.unmet.empty() && !claims.empty() ? Verdict::holds
                                                               : Verdict::does_not_hold;
  return finding;
}

Check check_of(const Json& kept) {
  const auto& sense = kept.at("sense").get_ref<const std::string&>();
  const Json& measured = kept.at("measured");
  return {.quantity = kept.at("quantity").get<std::string>(),
          .measured = measured.is_number() ? measured.get<double>() : std::nan(""),
          .expected = kept.at("expected").get<double>(),
          .tolerance = kept.at("tolerance").get<double>(),
          .reason = kept.at("reason").get<std::string>(),
          .sense = sense == "near"       ? Sense::near
                   : sense == "at_least" ? Sense::at_least
                                         : Sense::at_most};
}

Finding undecided(const std::string& why) {
  Finding finding;
  finding.conditions.push_back(why);
  finding.unmet.push_back(why);
  return finding;
}

JudgedClaim judged(const PartRow& row, Finding finding) {
  return {std::string(row.id), ClaimKind::verification, std::string(row.sentence), std::string(row.published),
          std::move(finding)};
}

} // namespace

std::span<const PartRow> part_rows() {
  static constexpr std::array rows{
      PartRow{"V1", "stress-strain curves of isotropic fibres agree with the law of Steinwachs et al. 2016",
              "curves agree very well (Fig 2C)", "fibres"},
      PartRow{"V2", "uniaxial fibres: somewhat stiffer along, very soft across", "curves of Fig 2D", "fibres-uniaxial"},
      PartRow{"V3", "lifetime of an adhesion against its force, Eq. 7", "tends to 60 min at high force (Fig 4)",
              "disassembly"},
      PartRow{"F1", "fields of displacement and von Mises stress over six hours at 100 and 400 Pa", "S1 to S4 Videos",
              ""}};
  return rows;
}

JudgedClaim judged_by_case(const PartRow& row, const validation::Result* result, const std::filesystem::path& folder) {
  if (result == nullptr) return judged(row, finding_of({}, {}, false, folder));
  return judged(row, finding_of(result->claims, result->claim_notes, result->holds(), folder));
}

JudgedClaim judged_by_kept_case(const PartRow& row, const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return judged(row, undecided("no results are kept"));
  const Json results = Json::parse(read_file(file, largest_file), nullptr, false);
  try {
    const Json& kept = results.at("cases").at(0);
    std::vector<Check> claims;
    for (const Json& claim : kept.at("claims")) claims.push_back(check_of(claim));
    return judged(row, finding_of(claims, kept.at("claim_notes").get<std::vector<std::string>>(),
                                  kept.at("holds").get<bool>(), file.parent_path()));
  } catch (const Json::exception&) {
    throw InputOutputError(fmt::format("{}: holds no results of a case", file.string()));
  }
}

std::string fields_csv(const Ensemble& study, const std::filesystem::path& folder) {
  std::string csv = fields_header();
  for (const Result& r : study.results) {
    const std::string& label = study.study.points[r.run.point].label;
    const bool asked = std::ranges::find(field_points, label) != std::end(field_points);
    if (r.run.replicate != 1 || !asked || !r.standing.done()) continue;
    const std::filesystem::path place = run_folder(folder, r.run);
    if (std::filesystem::exists(place)) csv += fields_rows(label, run::read_run(place).film);
  }
  return csv;
}

JudgedClaim judged_by_fields(const PartRow& row, const std::filesystem::path& file, const Evidence& evidence) {
  if (!std::filesystem::exists(file)) return judged(row, undecided("no results are kept"));
  JudgedClaim claim = judged(row, fields_shown(read_file(file, largest_file), six_hours));
  if (const auto found = evidence.find(field_study); found != evidence.end())
    claim.caveat = claims_caveat(found->second.study);
  return claim;
}

std::vector<JudgedClaim> rows_by_fields(const Evidence& evidence, const EvidenceOptions& options) {
  std::vector<JudgedClaim> rows;
  const std::filesystem::path folder = options.tables();
  for (const PartRow& row : part_rows()) {
    if (!row.verification.empty() || !options.chooses(row.id)) continue;
    if (const auto found = evidence.find(field_study); options.from.empty() && found != evidence.end())
      write_file(folder / "fields.csv", fields_csv(found->second, folder / field_study));
    rows.push_back(judged_by_fields(row, folder / "fields.csv", evidence));
  }
  return rows;
}

} // namespace matrigrate::study
