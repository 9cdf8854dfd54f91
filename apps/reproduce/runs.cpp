#include "apps/reproduce/runs.hpp"

#include "apps/study/pool_output.hpp"
#include "apps/study/verbs.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "run/folder_lock.hpp"
#include "study_results/read_results.hpp"

#include <fmt/format.h>

#include <optional>

namespace matrigrate::apps {

void ReproducedRuns::compute_missing(const StudyFolder& study, const std::vector<std::size_t>& runs) {
  make_study_folder(study);
  const FolderLock lock(study.folder, FolderLock::Kind::alone);
  write_study(study);
  const bool quiet = m_options.quiet || m_options.json;
  if (!quiet)
    print_error(fmt::format("{}: {} points x {} replicates\n", study.study.title, study.study.points.size(),
                            study.study.replicates));
  const PoolOutcome outcome = apps::compute(study, runs, {.jobs = job_count(m_options.jobs), .quiet = quiet});
  if (outcome.signal != 0) throw Stopped{outcome.signal};
  const std::string troubles = troubles_text(study, outcome.troubles);
  if (!troubles.empty()) print_error(troubles);
  if (outcome.cannot_write)
    throw InputOutputError(fmt::format("{}: a run could not write its files", study.folder.string()));
}

std::vector<study::Result> ReproducedRuns::compute(const StudyFolder& study, const std::vector<std::size_t>& runs,
                                                   const std::vector<study::Result>& kept) {
  std::optional<Stopped> stopped;
  try {
    compute_missing(study, runs);
  } catch (const Stopped& by) { // the tables tell how far it came
    stopped = by;
  }
  Collected tables = collect_tables(study, kept);
  auto results = study::with_kept(tables.results, kept);
  m_studies.emplace_back(study, std::move(tables));
  if (stopped) throw *stopped;
  return results;
}

void ReproducedRuns::write_reports() {
  for (auto& [study, tables] : m_studies)
    if (!study.folder.string().ends_with("-larger-disc")) write_study_report(study, tables);
}

} // namespace matrigrate::apps
