#include "apps/reproduce/parts.hpp"

#include "apps/case_output.hpp"
#include "apps/study/verbs.hpp"
#include "apps/terminal/stop_signal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/fields_shown.hpp"
#include "claims/study_claims.hpp"
#include "run/finished_run.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t largest_file = std::size_t{1} << 24U;

/// The results of a case in a results.json that is kept.
Json kept_case(const std::filesystem::path& file) {
  const Json results = Json::parse(read_file(file, largest_file), nullptr, false);
  if (results.is_discarded() || !results.contains("cases") || results.at("cases").empty())
    throw InputOutputError(fmt::format("{}: holds no results of a case", file.string()));
  return results.at("cases").at(0);
}

/// The verdict of a case's claims from its results.
study::Finding finding_of(const Json& verification, const std::filesystem::path& folder) {
  study::Finding finding;
  std::vector<std::string> brief;
  for (const Json& claim : verification.at("claims")) {
    const bool holds = claim.at("holds").get<bool>();
    const std::string sense = claim.at("sense").get<std::string>();
    const std::string bound = sense == "near" ? fmt::format("within {:.3g} of ", claim.at("tolerance").get<double>())
                                              : fmt::format("{} ", sense == "at_least" ? "at least" : "at most");
    const std::string measured =
        fmt::format("{}: {:.3g}", claim.at("quantity").get<std::string>(),
                    claim.at("measured").is_number() ? claim.at("measured").get<double>() : std::nan(""));
    const std::string wanted =
        fmt::format("{}{:.3g} ({})", bound, claim.at("expected").get<double>(), claim.at("reason").get<std::string>());
    finding.ours.push_back(measured);
    brief.push_back(measured);
    finding.conditions.push_back(fmt::format("{}: {}", wanted, holds ? "met" : "not met"));
    if (!holds) finding.unmet.push_back(fmt::format("{}, wanted {}", measured, wanted));
  }
  for (const Json& note : verification.at("claim_notes")) finding.ours.push_back(note.get<std::string>());
  const bool verified = verification.at("holds").get<bool>();
  if (!verified) {
    finding.conditions.push_back(
        fmt::format("the verification itself does not hold: see {}", (folder / "report.html").string()));
    finding.unmet.emplace_back("the verification itself does not hold");
  }
  const bool claims_hold = finding.unmet.empty() && !verification.at("claims").empty();
  finding.brief = fmt::format("{}", fmt::join(brief, "; "));
  finding.verdict = !verified     ? study::Verdict::undecided
                    : claims_hold ? study::Verdict::holds
                                  : study::Verdict::does_not_hold;
  return finding;
}

study::Finding undecided(const std::string& why) {
  study::Finding finding;
  finding.conditions.push_back(why);
  finding.unmet.push_back(why);
  return finding;
}

study::JudgedClaim judged(const PartRow& row, study::Finding finding) {
  return {std::string(row.id), study::ClaimKind::verification, std::string(row.sentence), std::string(row.published),
          std::move(finding)};
}

/// The films of F1 as a table: of the first replicates at 100 and 400 Pa.
std::string fields_of_runs(const study::Evidence& evidence, const ReproduceOptions& options) {
  constexpr std::string_view name = "stiffness";
  std::string csv = study::fields_header();
  const auto found = evidence.find(name);
  if (found == evidence.end()) return csv;
  for (const study::Result& r : found->second.results) {
    if (r.run.replicate != 1 || (r.run.point != 1 && r.run.point != 4) || !r.standing.done()) continue;
    const std::filesystem::path folder = study::run_folder(std::filesystem::path(options.folder) / name, r.run);
    if (!exists(folder)) continue; // of a kept run there are no frames
    const FinishedRun run = read_run(folder);
    csv += study::fields_rows(found->second.study.points[r.run.point].label, run.film);
  }
  return csv;
}

} // namespace

std::span<const PartRow> part_rows() {
  static constexpr PartRow rows[] = {
      {"V1", "stress-strain curves of isotropic fibres agree with the law of Steinwachs et al. 2016",
       "curves agree very well (Fig 2C)", "fibres"},
      {"V2", "uniaxial fibres: somewhat stiffer along, very soft across", "curves of Fig 2D", "fibres-uniaxial"},
      {"V3", "lifetime of an adhesion against its force, Eq. 7", "tends to 60 min at high force (Fig 4)",
       "disassembly"},
      {"F1", "fields of displacement and von Mises stress over six hours at 100 and 400 Pa", "S1 to S4 Videos", ""}};
  return rows;
}

study::JudgedClaim judged_by_case(const PartRow& row, const ReproduceOptions& options) {
  const std::string name = fmt::format("validate-{}", row.verification);
  if (!options.from.empty()) {
    const std::filesystem::path kept = std::filesystem::path(options.from) / (name + ".json");
    return judged(row, std::filesystem::exists(kept) ? finding_of(kept_case(kept), options.from)
                                                     : undecided("no results are kept"));
  }
  const std::filesystem::path folder = std::filesystem::path(options.folder) / name;
  make_output_folder(folder, true);
  const auto which = std::ranges::find(validation::cases(), row.verification, &validation::Case::name);
  const StopSignal stop; // a second one ends this program, and with it the case
  const std::vector<Outcome> outcomes =
      run_cases({&*which}, row.verification, validation::default_parameters(), folder, [](const Outcome&) {});
  if (StopSignal::received() != 0) throw Stopped{StopSignal::received()};
  return judged(row, finding_of(to_json(outcomes.front()), folder));
}

study::JudgedClaim judged_by_fields(const PartRow& row, const study::Evidence& evidence,
                                    const ReproduceOptions& options) {
  const std::filesystem::path file =
      std::filesystem::path(options.from.empty() ? options.folder : options.from) / "fields.csv";
  if (options.from.empty()) write_file(file, fields_of_runs(evidence, options));
  if (!std::filesystem::exists(file)) return judged(row, undecided("no results are kept"));
  study::JudgedClaim claim = judged(row, study::fields_shown(read_file(file, largest_file), 21600.0));
  if (const auto found = evidence.find("stiffness"); found != evidence.end())
    claim.caveat = study::claims_caveat(found->second.study);
  return claim;
}

} // namespace matrigrate::apps
