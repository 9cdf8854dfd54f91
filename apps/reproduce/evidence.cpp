#include "apps/reproduce/evidence.hpp"

#include "apps/study/files.hpp"
#include "apps/study/pool_output.hpp"
#include "apps/study/verbs.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/shipped_studies.hpp"
#include "parameters/presets.hpp"
#include "parameters/write.hpp"
#include "run/folder_lock.hpp"
#include "simulation/start_rules.hpp"
#include "study/read_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace matrigrate::apps {

namespace {

bool ended_at_rim(const study::Result& r) { return r.standing.cause == FailureCause::rim; }
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
  const std::string troubles = troubles_text(study, outcome.troubles);
  if (!troubles.empty()) print_error(troubles);
  if (outcome.signal != 0) throw Stopped{outcome.signal};
  if (outcome.cannot_write)
    throw InputOutputError(fmt::format("{}: a run could not write its files", study.folder.string()));
}

/// The study in a larger disc.
StudyFolder second_of(const StudyFolder& study, std::string_view name, const ReproduceOptions& options) {
  ReproduceOptions larger = options;
  larger.overrides.push_back(
      fmt::format("ecm.radius={} um", larger_disc * study.study.base.ecm.radius)); // lengths are in um
  return planned(shipped(name, larger), std::filesystem::path(options.folder) / fmt::format("{}-larger-disc", name));
}

/// Runs again, in a larger disc, those that ended at the rim. @return all results, these replaced; none if there were
/// none
std::vector<study::Result> in_larger_disc(const StudyFolder& study, const std::vector<study::Result>& results,
                                          std::string_view name, const ReproduceOptions& options) {
  if (std::ranges::none_of(results, ended_at_rim)) return {};
  const StudyFolder second = second_of(study, name, options);
  std::vector<std::size_t> runs;
  for (std::size_t k = 0; k < second.runs.size(); ++k)
    if (std::ranges::any_of(results, [&](const study::Result& r) {
          return ended_at_rim(r) && r.run.point == second.runs[k].point && r.run.replicate == second.runs[k].replicate;
        }))
      runs.push_back(k);
  compute_missing(second, runs, options);
  std::vector<study::Result> all = results;
  for (study::Result& r : study::results(second.study, second.runs, second.folder)) {
    const auto same = std::ranges::find_if(
        all, [&](const study::Result& a) { return a.run.point == r.run.point && a.run.replicate == r.run.replicate; });
    if (ended_at_rim(*same)) *same = std::move(r);
  }
  return all;
}

/// Adds the kept results of a study, if there are any. They must be of the very runs of the shipped study: the name of
/// a run is a fingerprint of all parameters that decide on its results.
void add_kept(study::Evidence& evidence, std::string_view name, const ReproduceOptions& options) {
  constexpr std::size_t largest_table = std::size_t{1} << 28U;
  const std::filesystem::path file = std::filesystem::path(options.from) / fmt::format("{}-results.csv", name);
  if (!std::filesystem::exists(file)) return;
  StudyFolder study = planned(shipped(name, options), {});
  auto results = study::read_results(study.study, read_file(file, largest_table), file.string());
  for (const study::Result& r : results)
    if (std::ranges::none_of(study.runs, [&](const study::Run& run) {
          return run.hash == r.run.hash && run.seed == r.run.seed && run.point == r.run.point
                 && run.replicate == r.run.replicate;
        }))
      throw InputOutputError(fmt::format("{}: run {} does not belong to the study: its parameters are different",
                                         file.string(), r.run.hash));
  evidence.emplace(name, study::Ensemble{std::move(study.study), std::move(results)});
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
  if (options.closures == "first") {
    const std::vector<std::string> first = first_closures();
    changes.overrides.insert(changes.overrides.begin(), first.begin(), first.end());
  }
  changes.overrides.insert(changes.overrides.begin(), "run.integrator=" + options.integrator);
  const std::filesystem::path kept = std::filesystem::path(options.from) / fmt::format("{}.toml", name);
  if (!options.from.empty() && std::filesystem::exists(kept)) // kept runs of an earlier form of the study
    return study::parse_study(read_file(kept, std::size_t{1} << 20U), kept.string(), options.from, changes);
  return study::parse_study(study::shipped_file(name, options.set()).text, fmt::format("studies/{}.toml", name), ".",
                            changes);
}

ClaimEvidence gather_evidence(const std::vector<study::Claim>& claims, const ReproduceOptions& options) {
  std::vector<std::string> names;
  for (const study::Claim& claim : claims)
    for (const std::string& name : claim.studies())
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  ClaimEvidence all;
  std::vector<std::pair<StudyFolder, Collected>> collected;
  for (const std::string& name : names) {
    if (!options.from.empty()) {
      add_kept(all.evidence, name, options);
      continue;
    }
    StudyFolder study = planned(shipped(name, options), std::filesystem::path(options.folder) / name);
    std::vector<std::size_t> runs(study.runs.size());
    std::iota(runs.begin(), runs.end(), std::size_t{0});
    compute_missing(study, runs, options);
    Collected tables = collect_tables(study);
    if (auto larger = in_larger_disc(study, tables.results, name, options); !larger.empty())
      all.larger.emplace(name, study::Ensemble{study.study, std::move(larger)});
    all.evidence.emplace(name, study::Ensemble{study.study, tables.results});
    collected.emplace_back(std::move(study), std::move(tables));
  }
  for (auto& [study, tables] : collected) write_study_report(study, tables); // claims may need several studies
  return all;
}

std::string ends_text(const study::Ensemble& ensemble) {
  const auto count = [&](const auto& condition) { return std::ranges::count_if(ensemble.results, condition); };
  const auto finished = count([](const study::Result& r) { return r.standing.done(); });
  const auto rim = count(ended_at_rim);
  const auto crossing = count(crossed_itself);
  const auto all = static_cast<std::ptrdiff_t>(ensemble.results.size());
  return fmt::format("{} of {} runs done; {} ended at the rim, {} by crossing themselves, {} otherwise", finished, all,
                     rim, crossing, all - finished - rim - crossing);
}

} // namespace matrigrate::apps
