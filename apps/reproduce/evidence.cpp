#include "apps/reproduce/evidence.hpp"

#include "apps/study/files.hpp"
#include "apps/study/pool_output.hpp"
#include "apps/study/verbs.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/shipped_studies.hpp"
#include "parameters/write.hpp"
#include "run/folder_lock.hpp"
#include "run/provenance.hpp"
#include "simulation/start_rules.hpp"
#include "study/read_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace matrigrate::apps {

namespace {

bool crossed_itself(const study::Result& r) { return r.standing.cause == FailureCause::crossing; }

/// Computes those of the given runs that are missing.
/// @throws Stopped, InputOutputError
void compute_missing(const StudyFolder& study, const std::vector<std::size_t>& runs, const ReproduceOptions& options) {
  make_study_folder(study);
  const FolderLock lock(study.folder, FolderLock::Kind::alone);
  write_study(study);
  const bool quiet = options.quiet || options.json || options.markdown;
  if (!quiet)
    print_error(fmt::format("{}: {} points x {} replicates\n", study.study.title, study.study.points.size(),
                            study.study.replicates));
  const PoolOutcome outcome = compute(study, runs, {.jobs = job_count(options.jobs), .quiet = quiet});
  if (outcome.signal != 0) throw Stopped{outcome.signal};
  const std::string troubles = troubles_text(study, outcome.troubles);
  if (!troubles.empty()) print_error(troubles);
  if (outcome.cannot_write)
    throw InputOutputError(fmt::format("{}: a run could not write its files", study.folder.string()));
}

/// The results in the table NAME-results.csv of a folder; none if it is not there. They must be of the very runs of the
/// study: the name of a run is a fingerprint of all parameters that decide on its results.
std::vector<study::Result> kept_results(const StudyFolder& study, const std::string& folder, std::string_view name) {
  constexpr std::size_t largest_table = std::size_t{1} << 28U;
  const std::filesystem::path file = std::filesystem::path(folder) / fmt::format("{}-results.csv", name);
  if (folder.empty() || !std::filesystem::exists(file)) return {};
  auto results = study::read_results(study.study, read_file(file, largest_table), file.string());
  for (const study::Result& r : results)
    if (std::ranges::none_of(study.runs, [&](const study::Run& run) {
          return run.hash == r.run.hash && run.seed == r.run.seed && run.point == r.run.point
                 && run.replicate == r.run.replicate;
        }))
      throw InputOutputError(
          fmt::format("{}: run {} does not belong to the study: its parameters are different, or it was named by a "
                      "version of the program that names runs otherwise than this one, {}",
                      file.string(), r.run.hash, run::version_text()));
  return results;
}

/// Puts results that have ended in the place of those of the same runs for which `replaced` holds.
template <class Replaced>
void replace(std::vector<study::Result>& results, const std::vector<study::Result>& by, const Replaced& replaced) {
  for (const study::Result& r : by) {
    if (!r.standing.ended()) continue;
    for (study::Result& old : results)
      if (old.run.point == r.run.point && old.run.replicate == r.run.replicate && replaced(old)) old = r;
  }
}

/// A study and its results.
struct Computed {
  StudyFolder study;
  Collected tables;                   ///< of the runs in its folder
  std::vector<study::Result> results; ///< of these, and of the runs that are kept
};

/// Computes those of the wanted runs of a study that are neither in its folder nor kept, and writes its tables;
/// results.csv holds the kept runs as well.
/// @param wanted  of a run
template <class Wanted>
Computed computed(StudyFolder study, std::string_view name, const ReproduceOptions& options, const Wanted& wanted) {
  const std::vector<study::Result> kept = kept_results(study, options.kept, name);
  std::vector<std::size_t> runs;
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    const auto same = [&](const study::Result& r) { return r.standing.ended() && r.run.hash == study.runs[k].hash; };
    if (wanted(study.runs[k]) && std::ranges::none_of(kept, same)) runs.push_back(k);
  }
  std::optional<Stopped> stopped;
  try {
    compute_missing(study, runs, options);
  } catch (const Stopped& by) { // the tables tell how far it came
    stopped = by;
  }
  Computed all{std::move(study), {}, {}};
  all.tables = collect_tables(all.study, kept);
  all.results = with_kept(all.tables.results, kept);
  if (stopped) throw *stopped;
  return all;
}

std::string larger_name(std::string_view name) { return fmt::format("{}-larger-disc", name); }

/// The study in a larger disc, in its own folder.
StudyFolder second_of(const StudyFolder& study, std::string_view name, const ReproduceOptions& options) {
  ReproduceOptions larger = options;
  larger.overrides.push_back(
      fmt::format("ecm.radius={} um", study::larger_disc * study.study.base.ecm.radius)); // lengths are in um
  return planned(shipped(name, larger), std::filesystem::path(options.folder) / larger_name(name));
}

/// Runs again, in a larger disc, those that ended at the rim, of points that decide on claims.
/// @return all results, these replaced; none if there were none
std::vector<study::Result> in_larger_disc(const StudyFolder& study, const std::vector<study::Result>& results,
                                          const std::string& name, const std::vector<study::Claim>& claims,
                                          const ReproduceOptions& options) {
  const auto again = [&](const study::Result& r) {
    const std::string& label = study.study.points[r.run.point].label;
    return study::ended_at_rim(r)
           && std::ranges::any_of(claims, [&](const auto& c) { return c.depends_on(name, label); });
  };
  if (std::ranges::none_of(results, again)) return {};
  const Computed second =
      computed(second_of(study, name, options), larger_name(name), options, [&](const study::Run& run) {
        return std::ranges::any_of(results, [&](const study::Result& r) {
          return again(r) && r.run.point == run.point && r.run.replicate == run.replicate;
        });
      });
  std::vector<study::Result> all = results;
  replace(all, second.results, study::ended_at_rim);
  return all;
}

/// Adds the kept results of a study, if there are any, and those in a larger disc.
void add_kept(ClaimEvidence& all, std::string_view name, const ReproduceOptions& options) {
  StudyFolder study = planned(shipped(name, options), {});
  auto results = kept_results(study, options.from, name);
  if (results.empty()) return;
  const auto second = kept_results(second_of(study, name, options), options.from, larger_name(name));
  if (!second.empty()) {
    auto larger = results;
    replace(larger, second, study::ended_at_rim);
    all.larger.emplace(name, study::Ensemble{study.study, std::move(larger)});
  }
  all.evidence.emplace(name, study::Ensemble{std::move(study.study), std::move(results)});
}

} // namespace

void require_own_study_folders(const std::vector<study::Claim>& claims, const ReproduceOptions& options) {
  if (!options.from.empty()) return;
  for (const study::Claim& claim : claims)
    for (const std::string& name : claim.studies()) {
      const std::filesystem::path folder(options.folder);
      const StudyFolder study = planned(shipped(name, options), folder / name);
      study::require_own_folder(study);
      study::require_own_folder(second_of(study, name, options));
    }
}

study::Study shipped(std::string_view name, const ReproduceOptions& options) {
  study::Changes changes{options.overrides, options.replicates, start_rules()};
  changes.overrides.insert(changes.overrides.begin(), "run.integrator=" + options.integrator);
  const std::filesystem::path kept = std::filesystem::path(options.from) / fmt::format("{}.toml", name);
  if (!options.from.empty() && std::filesystem::exists(kept)) // kept runs of an earlier form of the study
    return study::parse_study(read_file(kept, std::size_t{1} << 20U), kept.string(), options.from, changes);
  return study::parse_study(study::shipped_file(name).text, fmt::format("studies/{}.toml", name), ".", changes);
}

ClaimEvidence gather_evidence(const std::vector<study::Claim>& claims, const ReproduceOptions& options) {
  std::vector<std::string> names;
  for (const study::Claim& claim : claims)
    for (const std::string& name : claim.studies())
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  ClaimEvidence all;
  std::vector<Computed> studies;
  for (const std::string& name : names) {
    if (!options.from.empty()) {
      add_kept(all, name, options);
      continue;
    }
    StudyFolder study = planned(shipped(name, options), std::filesystem::path(options.folder) / name);
    Computed one = computed(std::move(study), name, options, [](const study::Run&) { return true; });
    if (auto larger = in_larger_disc(one.study, one.results, name, claims, options); !larger.empty())
      all.larger.emplace(name, study::Ensemble{one.study.study, std::move(larger)});
    all.evidence.emplace(name, study::Ensemble{one.study.study, one.results});
    studies.push_back(std::move(one));
  }
  for (Computed& one : studies) write_study_report(one.study, one.tables); // claims may need several studies
  return all;
}

std::string ends_text(const study::Ensemble& ensemble) {
  const auto count = [&](const auto& condition) { return std::ranges::count_if(ensemble.results, condition); };
  const auto finished = count([](const study::Result& r) { return r.standing.done(); });
  const auto rim = count(study::ended_at_rim);
  const auto crossing = count(crossed_itself);
  const auto all = static_cast<std::ptrdiff_t>(ensemble.results.size());
  return fmt::format("{} of {} runs done; {} ended at the rim, {} by crossing themselves, {} otherwise", finished, all,
                     rim, crossing, all - finished - rim - crossing);
}

} // namespace matrigrate::apps
