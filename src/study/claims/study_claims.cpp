#include "claims/claims.hpp"

#include "parameters/read.hpp"
#include "parameters/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace matrigrate::study {

namespace {

bool same_points(const Study& a, const Study& b) {
  return a.title == b.title && std::ranges::equal(a.points, b.points, [](const auto& x, const auto& y) {
           return x.label == y.label && x.settings == y.settings;
         });
}

const ReadStudy* shipped_study(const Study& study) {
  for (const ReadStudy& shipped : read_shipped_studies())
    if (same_points(shipped.study, study)) return &shipped;
  return nullptr;
}

/// By which its claims call a study that is not shipped: the name of its file, from that of its folder.
std::string own_name(const std::filesystem::path& folder) {
  constexpr std::string_view ending = "-study";
  const std::string name = full_path(folder).filename();
  return name.ends_with(ending) ? name.substr(0, name.size() - ending.size()) : name;
}

Ensemble ensemble(const StudyFolder& study, const std::vector<Result>& results) {
  return {study.study, results, run_msd(study.study, results, {study.folder / "paths.csv"})};
}

/// The results of a study that lies beside another one; nothing if it does not.
/// @param shipped  whether it must be the shipped one of its name
std::optional<Ensemble> beside(const std::filesystem::path& folder, std::string_view name, bool shipped) {
  const std::filesystem::path parent = full_path(folder).parent_path();
  for (const std::string& sibling : {std::string(name), fmt::format("{}-study", name)}) {
    try {
      const StudyFolder other = open_study(parent / sibling);
      const ReadStudy* known = shipped ? shipped_study(other.study) : nullptr;
      if (!shipped || (known != nullptr && known->name == name))
        return ensemble(other, results(other.study, other.runs, other.folder));
    } catch (const std::runtime_error&) { // is not there, or cannot be read: the claim stays undecided
    }
  }
  return {};
}

/// In what a study is not the shipped one.
struct Deviations {
  std::vector<std::string> sentences;
  bool comparable = true; ///< the runs stand for the paper's all the same: other steps of the integrator
};

Deviations deviations(const Study& study) {
  const ReadStudy* shipped = shipped_study(study);
  if (shipped == nullptr) return {};
  Study published = shipped->study;
  published.base = apply_overrides(published.base, {"run.integrator=reference"}); // the paper's
  Deviations found;
  if (study.replicates != published.replicates)
    found.sentences.push_back(fmt::format("replicates {} (published: {})", study.replicates, published.replicates));
  found.comparable = found.sentences.empty();
  for (const Row& row : schema()) {
    const bool decides = !row.path.starts_with("output.") && row.path != "run.seed" && row.path != "run.threads";
    if (!decides || !differs(row, study.base, published.base)) continue;
    found.sentences.push_back(
        fmt::format("{} {} (published: {})", row.path, value_text(row, study.base), value_text(row, published.base)));
    found.comparable = found.comparable && (row.path == "run.integrator" || row.path == "run.time_step");
  }
  return found;
}

/// "3 of 8 runs ended at the rim: means are of the slower cells", of the points that a claim depends on; "" if
/// none did.
std::string rim_caveat(const Claim& claim, const Evidence& evidence) {
  std::size_t all = 0;
  std::size_t lost = 0;
  for (const auto& [name, ensemble] : evidence)
    for (const Result& r : ensemble.results)
      if (claim.depends_on(name, ensemble.study.points[r.run.point].label)) {
        ++all;
        if (ended_at_rim(r)) ++lost;
      }
  if (lost == 0) return {};
  return fmt::format("{} of {} runs ended at the rim: means are of the slower cells", lost, all);
}

} // namespace

std::vector<JudgedClaim> claims_about(const StudyFolder& study, const std::vector<Result>& results) {
  const ReadStudy* shipped = shipped_study(study.study);
  const std::string name = shipped != nullptr ? shipped->name : own_name(study.folder);
  std::vector<Claim> claims = study.study.claims;
  for (Claim& claim : claims) claim.study = name;
  if (shipped != nullptr)
    for (Claim& claim : shipped_claims())
      if (std::ranges::find(claims, claim.id, &Claim::id) == claims.end()) claims.push_back(std::move(claim));
  Evidence all;
  all.emplace(name, ensemble(study, results));
  std::vector<JudgedClaim> judged;
  for (const Claim& claim : claims) {
    const std::vector<std::string> needed = claim.studies();
    if (std::ranges::find(needed, name) == needed.end()) continue;
    Evidence evidence; // of this claim alone, so that a single study is not named in each sentence
    for (const std::string& other : needed) {
      if (!all.contains(other))
        if (auto found = beside(study.folder, other, shipped != nullptr)) all.emplace(other, *std::move(found));
      if (const auto known = all.find(other); known != all.end()) evidence.insert(*known);
    }
    JudgedClaim& about = judged.emplace_back(judged_claim(claim, evidence));
    if (const std::string rim = rim_caveat(claim, evidence); !rim.empty())
      about.caveat += (about.caveat.empty() ? "" : "; ") + rim;
  }
  return judged;
}

std::string claims_note(const Study& study) {
  const Deviations found = deviations(study);
  if (found.sentences.empty()) return {};
  return fmt::format("Not run as published: {}.{}", fmt::join(found.sentences, ", "),
                     found.comparable ? "" : " So these are no verdicts on the paper.");
}

const std::vector<ReadStudy>& read_shipped_studies() {
  static const std::vector<ReadStudy> all = [] {
    std::vector<ReadStudy> read;
    for (const ShippedStudy& shipped : shipped_studies())
      read.push_back(
          {std::string(shipped.name), parse_study(shipped.text, fmt::format("studies/{}.toml", shipped.name), ".")});
    return read;
  }();
  return all;
}

LabelsOf other_studies(const std::filesystem::path& folder) {
  return [folder](const std::string& name) -> std::optional<std::vector<std::string>> {
    const std::filesystem::path file = folder / (name + ".toml");
    if (std::filesystem::exists(file)) return all_labels(read_study(file).points);
    for (const ReadStudy& shipped : read_shipped_studies())
      if (shipped.name == name) return all_labels(shipped.study.points);
    return {};
  };
}

const ShippedStudy& shipped_file(std::string_view name) {
  const auto all = shipped_studies();
  const auto found = std::ranges::find(all, name, &ShippedStudy::name);
  if (found == all.end()) throw std::out_of_range(fmt::format("there is no shipped study {}", name));
  return *found;
}

std::vector<Claim> shipped_claims() {
  std::vector<Claim> all;
  for (const ReadStudy& shipped : read_shipped_studies())
    for (Claim claim : shipped.study.claims) {
      claim.study = shipped.name;
      all.push_back(std::move(claim));
    }
  std::ranges::sort(all, {}, &Claim::id);
  return all;
}

JudgedClaim judged_claim(const Claim& claim, const Evidence& evidence) {
  JudgedClaim result{claim.id, claim.kind, claim.sentence, claim.published, judged(claim, evidence)};
  if (claim.has_editions()) result.second_edition = judged(claim, evidence, ClaimEdition::second);
  for (const std::string& name : claim.studies())
    if (const auto found = evidence.find(name); found != evidence.end()) {
      if (!deviations(found->second.study).comparable) result.caveat = "not the paper's runs";
      result.studies.push_back(name);
    }
  return result;
}

} // namespace matrigrate::study
