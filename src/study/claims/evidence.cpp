#include "claims/claims.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "run/provenance.hpp"
#include "simulation/start.hpp"
#include "study_results/results.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

namespace matrigrate::study {

namespace {

/// The results in the table NAME-results.csv of a folder; none if it is not there. They must be of the very runs of the
/// study: the name of a run is a fingerprint of all parameters that decide on its results.
std::vector<Result> kept_results(const StudyFolder& study, const std::string& folder, std::string_view name) {
  const std::filesystem::path file = std::filesystem::path(folder) / fmt::format("{}-results.csv", name);
  if (folder.empty() || !std::filesystem::exists(file)) return {};
  auto results = read_results(study.study, read_file(file, largest_table), file.string());
  for (const Result& r : results)
    if (std::ranges::find(study.runs, r.run) == study.runs.end())
      throw InputOutputError(
          fmt::format("{}: run {} does not belong to the study: its parameters are different, or it was named by a "
                      "version of the program that names runs otherwise than this one, {}",
                      file.string(), r.run.hash, run::version_text()));
  return results;
}

/// The results of a study, after those of the wanted runs are computed that are neither in its folder nor kept.
/// @param wanted  of a run
template <class Wanted>
std::vector<Result> computed(const StudyFolder& study, std::string_view name, const EvidenceOptions& options,
                             const Compute& compute, const Wanted& wanted) {
  const std::vector<Result> kept = kept_results(study, options.kept, name);
  std::vector<std::size_t> runs;
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    const auto same = [&](const Result& r) { return r.standing.ended() && r.run.hash == study.runs[k].hash; };
    if (wanted(study.runs[k]) && std::ranges::none_of(kept, same)) runs.push_back(k);
  }
  return compute(study, runs, kept);
}

std::string larger_name(std::string_view name) { return fmt::format("{}-larger-disc", name); }

/// The study in a larger disc, in its own folder.
StudyFolder second_of(const StudyFolder& study, std::string_view name, const EvidenceOptions& options) {
  EvidenceOptions larger = options;
  larger.overrides.push_back(
      fmt::format("ecm.radius={} um", larger_disc * study.study.base.ecm.radius)); // lengths are in um
  return planned(shipped(name, larger), std::filesystem::path(options.folder) / larger_name(name));
}

/// Runs again, in a larger disc, those that ended at the rim, of points that decide on claims.
/// @return all results, these replaced; none if there were none
std::vector<Result> in_larger_disc(const StudyFolder& study, const std::vector<Result>& results,
                                   const std::string& name, const std::vector<Claim>& claims,
                                   const EvidenceOptions& options, const Compute& compute) {
  const auto again = [&](const Result& r) {
    const std::string& label = study.study.points[r.run.point].label;
    return ended_at_rim(r) && std::ranges::any_of(claims, [&](const Claim& c) { return c.depends_on(name, label); });
  };
  if (std::ranges::none_of(results, again)) return {};
  const std::vector<Result> second =
      computed(second_of(study, name, options), larger_name(name), options, compute, [&](const Run& run) {
        return std::ranges::any_of(results, [&](const Result& r) {
          return again(r) && r.run.point == run.point && r.run.replicate == run.replicate;
        });
      });
  return replaced(results, second, ended_at_rim);
}

/// Where the paths of a study may be: beside its runs, or kept.
std::vector<std::filesystem::path> path_tables(const std::string& name, const EvidenceOptions& options) {
  std::vector<std::filesystem::path> files;
  if (options.from.empty()) files.push_back(std::filesystem::path(options.folder) / name / "paths.csv");
  for (const std::string& kept : {options.from, options.kept})
    if (!kept.empty()) files.push_back(std::filesystem::path(kept) / fmt::format("{}-paths.csv", name));
  return files;
}

/// Adds a study to the evidence. @param larger  the results with those in a larger disc; empty if there are none
void add(ClaimEvidence& all, const Study& study, const std::string& name, const EvidenceOptions& options,
         const std::vector<Result>& results, const std::vector<Result>& larger) {
  const std::vector<std::filesystem::path> paths = path_tables(name, options);
  if (!larger.empty()) {
    std::vector<std::filesystem::path> those = path_tables(larger_name(name), options);
    those.insert(those.end(), paths.begin(), paths.end());
    all.larger.emplace(name, Ensemble{study, larger, run_msd(study, larger, those)});
  }
  all.evidence.emplace(name, Ensemble{study, results, run_msd(study, results, paths)});
}

/// Adds the kept results of a study, if there are any, and those in a larger disc.
void add_kept(ClaimEvidence& all, const std::string& name, const EvidenceOptions& options) {
  const StudyFolder study = planned(shipped(name, options), {});
  const auto results = kept_results(study, options.from, name);
  if (results.empty()) return;
  const auto second = kept_results(second_of(study, name, options), options.from, larger_name(name));
  add(all, study.study, name, options, results,
      second.empty() ? std::vector<Result>() : replaced(results, second, ended_at_rim));
}

} // namespace

MsdCurves run_msd(const Study& study, const std::vector<Result>& results,
                  const std::vector<std::filesystem::path>& tables) {
  constexpr double path_interval = 600.0; // of paths.csv [s]
  RowsByRun all;
  for (const std::filesystem::path& file : tables)
    if (std::filesystem::exists(file))
      naming(file, [&] {
        all.merge(rows_by_run(read_file(file, largest_table), {"t_s", "x_um", "y_um", "replicate"}));
      });
  MsdCurves curves;
  for (const Result& r : results) {
    std::map<double, std::vector<TrackRow>> paths; // of the cells
    for (const std::vector<double>& row : all[{study.points[r.run.point].label, fmt::to_string(r.run.replicate)}]) {
      TrackRow& at = paths[row.size() > 4 ? row[4] : 1.0].emplace_back();
      at.t = row[0];
      at.centre = {row[1], row[2]};
    }
    MsdCurves cells;
    for (const auto& [cell, path] : paths) cells.push_back(mean_square_displacement(path, path_interval));
    curves.push_back(mean_curve(cells));
  }
  return curves;
}

std::vector<std::string> studies_of(const std::vector<Claim>& claims) {
  std::vector<std::string> names;
  for (const Claim& claim : claims)
    for (const std::string& name : claim.studies())
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

void require_own_study_folders(const std::vector<Claim>& claims, const EvidenceOptions& options) {
  if (!options.from.empty()) return;
  for (const std::string& name : studies_of(claims)) {
    const StudyFolder study = planned(shipped(name, options), std::filesystem::path(options.folder) / name);
    require_own_folder(study);
    require_own_folder(second_of(study, name, options));
  }
}

Study shipped(std::string_view name, const EvidenceOptions& options) {
  Changes changes{options.overrides, options.replicates, start_rules()};
  changes.overrides.insert(changes.overrides.begin(), "run.integrator=" + options.integrator);
  const std::filesystem::path kept = std::filesystem::path(options.from) / fmt::format("{}.toml", name);
  if (!options.from.empty() && std::filesystem::exists(kept)) // kept runs of an earlier form of the study
    return parse_study(read_file(kept, std::size_t{1} << 20U), kept.string(), options.from, changes);
  return parse_study(shipped_file(name).text, fmt::format("studies/{}.toml", name), ".", changes);
}

ClaimEvidence gather_evidence(const std::vector<Claim>& claims, const EvidenceOptions& options,
                              const Compute& compute) {
  ClaimEvidence all;
  for (const std::string& name : studies_of(claims)) {
    if (!options.from.empty()) {
      add_kept(all, name, options);
      continue;
    }
    const StudyFolder study = planned(shipped(name, options), std::filesystem::path(options.folder) / name);
    const std::vector<Result> results = computed(study, name, options, compute, [](const Run&) { return true; });
    add(all, study.study, name, options, results, in_larger_disc(study, results, name, claims, options, compute));
  }
  return all;
}

std::vector<JudgedClaim> judged_claims(const std::vector<Claim>& claims, const ClaimEvidence& all) {
  std::vector<JudgedClaim> rows;
  for (const Claim& claim : claims) {
    JudgedClaim& row = rows.emplace_back(judged_claim(claim, all.evidence));
    Evidence larger;
    for (const std::string& name : claim.studies())
      if (const auto found = all.larger.find(name); found != all.larger.end()) larger.insert(*found);
    if (larger.empty()) continue;
    for (const std::string& name : row.studies) larger.insert(*all.evidence.find(name));
    row.in_larger_disc = judged(claim, larger);
  }
  return rows;
}

std::string ends_text(const Ensemble& ensemble) {
  const auto count = [&](const auto& condition) { return std::ranges::count_if(ensemble.results, condition); };
  const auto finished = count([](const Result& r) { return r.standing.done(); });
  const auto rim = count(ended_at_rim);
  const auto crossing = count([](const Result& r) { return r.standing.cause == FailureCause::crossing; });
  const auto all = static_cast<std::ptrdiff_t>(ensemble.results.size());
  std::vector<std::string> ends;
  for (const auto& [n, how] : {std::pair(rim, "at the rim"), std::pair(crossing, "by crossing itself"),
                               std::pair(all - finished - rim - crossing, "otherwise")})
    if (n > 0) ends.push_back(fmt::format("{} {}{}", n, ends.empty() ? "ended " : "", how));
  return fmt::format("{} of {} runs done{}{}", finished, all, ends.empty() ? "" : "; ", fmt::join(ends, ", "));
}

} // namespace matrigrate::study
