#include "claims/study_claims.hpp"

#include "base/failure.hpp"
#include "claims/shipped_studies.hpp"
#include "parameters/presets.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "parameters/write.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate::study {

namespace {

study::Study parsed(const ShippedStudy& shipped) {
  return study::parse_study(shipped.text, fmt::format("studies/{}.toml", shipped.name), ".");
}

bool same_points(const study::Study& a, const study::Study& b) {
  return a.title == b.title && std::ranges::equal(a.points, b.points, [](const auto& x, const auto& y) {
           return x.settings == y.settings;
         });
}

const ShippedStudy* shipped_study(const study::Study& study) {
  for (const ShippedStudy& shipped : shipped_studies())
    if (same_points(parsed(shipped), study)) return &shipped;
  return nullptr;
}

/// The results of a shipped study that lies beside another one; nothing if it does not.
std::optional<study::Ensemble> beside(const std::filesystem::path& folder, std::string_view name) {
  const std::filesystem::path place = std::filesystem::absolute(folder).lexically_normal();
  const std::filesystem::path parent = place.has_filename() ? place.parent_path() : place.parent_path().parent_path();
  for (const std::string& sibling : {std::string(name), fmt::format("{}-study", name)}) {
    try {
      const StudyFolder other = study::open_study(parent / sibling);
      if (shipped_name(other.study) == name)
        return study::Ensemble{other.study, study::results(other.study, other.runs, other.folder)};
    } catch (const InputOutputError&) { // is not there, or cannot be read: the claim stays undecided
    } catch (const ConfigurationError&) {
    }
  }
  return {};
}

bool decides_on_results(const Row& row) {
  return !row.path.starts_with("output.") && row.path != "run.seed" && row.path != "run.threads";
}

/// Whether the parameters are those of the first set of closures.
bool has_first_closures(const Parameters& p) {
  return values_text(apply_overrides(p, first_closures())) == values_text(p);
}

/// In what a study is not the shipped one.
struct Deviations {
  std::vector<std::string> sentences;
  bool comparable = true; ///< the runs stand for the paper's all the same: other steps of the integrator
};

Deviations deviations(const study::Study& study) {
  const ShippedStudy* shipped = shipped_study(study);
  if (shipped == nullptr) return {};
  study::Study published = parsed(*shipped);
  if (has_first_closures(study.base)) published.base = apply_overrides(published.base, first_closures());
  published.base = apply_overrides(published.base, {"run.integrator=reference"}); // the paper's
  Deviations found;
  if (study.replicates != published.replicates)
    found.sentences.push_back(fmt::format("replicates {} (published: {})", study.replicates, published.replicates));
  found.comparable = found.sentences.empty();
  for (const Row& row : schema()) {
    const std::string here = value_text(row, study.base);
    const std::string there = value_text(row, published.base);
    if (here == there || !decides_on_results(row)) continue;
    found.sentences.push_back(fmt::format("{} {} (published: {})", row.path, here, there));
    found.comparable = found.comparable && (row.path == "run.integrator" || row.path == "run.time_step");
  }
  return found;
}

} // namespace

std::optional<std::string_view> shipped_name(const study::Study& study) {
  const ShippedStudy* shipped = shipped_study(study);
  if (shipped == nullptr) return {};
  return shipped->name;
}

std::vector<study::JudgedClaim> claims_about(const StudyFolder& study, const std::vector<study::Result>& results) {
  const std::optional<std::string_view> name = shipped_name(study.study);
  if (!name) return {};
  study::Evidence all;
  all.emplace(*name, study::Ensemble{study.study, results});
  std::vector<study::JudgedClaim> judged;
  for (const study::Claim& claim : study::all_claims()) {
    if (std::ranges::find(claim.studies, *name) == claim.studies.end()) continue;
    study::Evidence evidence; // of this claim alone, so that a single study is not named in each sentence
    for (const std::string_view other : claim.studies) {
      if (!all.contains(other))
        if (auto found = beside(study.folder, other)) all.emplace(other, *std::move(found));
      if (const auto known = all.find(other); known != all.end()) evidence.insert(*known);
    }
    judged.push_back(study::judged(claim, evidence));
  }
  return judged;
}

std::string claims_note(const study::Study& study) {
  const Deviations found = deviations(study);
  if (found.sentences.empty()) return {};
  return fmt::format("Not run as published: {}.{}", fmt::join(found.sentences, ", "),
                     found.comparable ? "" : " So these are no verdicts on the paper.");
}

std::string claims_caveat(const study::Study& study) {
  return deviations(study).comparable ? "" : "not the paper's runs";
}

std::string claims_caveat(const std::string& id, const study::Evidence& evidence) {
  const auto claims = study::all_claims();
  const auto claim = std::ranges::find(claims, id, &study::Claim::id);
  std::vector<std::string_view> names;
  if (claim != claims.end()) names = claim->studies;
  if (id == "F1") names = {"stiffness"}; // whose frames it is judged by
  for (const std::string_view name : names)
    if (const auto found = evidence.find(name); found != evidence.end())
      if (std::string caveat = claims_caveat(found->second.study); !caveat.empty()) return caveat;
  return {};
}

} // namespace matrigrate::study
