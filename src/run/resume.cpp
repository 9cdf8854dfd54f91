#include "run/resume.hpp"

#include "run/stopped_run.hpp"
#include "simulation/start.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace matrigrate::run {

namespace {

RunOutcome done_before(const RunOptions& options, const Json& record, RunObserver& observer) {
  restore_scenario(options.folder, observer);
  RunOutcome outcome;
  outcome.folder = options.folder;
  outcome.computed = false;
  outcome.record = record;
  return outcome;
}

RunOutcome resume_from(const FoundCheckpoint& found, const RunOptions& options, const Json& record,
                       std::optional<int> threads, RunObserver& observer) {
  require_computable(found.p, options.folder);
  warn_of_other_program(found, observer);
  scenario_of(options.folder, observer); // says so if it cannot be read; it is written again
  RunStart start = start_from(found, record);
  if (threads) start.p.run.threads = *threads;
  start.lineage.push_back(event("resumed", found));
  return run(std::move(start), options, observer);
}

} // namespace

RunOutcome resume(const RunOptions& options, const ResumeOptions& from, RunObserver& observer) {
  const Json record = record_of(options.folder);
  if (!from.previous && is_done(options.folder, record, observer)) return done_before(options, record, observer);
  return resume_from(before_shortened_end(last_checkpoint(options.folder, from.previous), options.folder), options,
                     record, from.threads, observer);
}

RunOutcome resume(const RunOptions& options, const Parameters& p, RunObserver& observer) {
  const Json record = record_of(options.folder);
  if (is_done(options.folder, record, observer)) return done_before(options, record, observer);
  if (has_checkpoint(options.folder))
    return resume_from(before_shortened_end(whole_checkpoint(options.folder, observer), options.folder), options,
                       record, p.run.threads, observer);
  return run({.s = initial_state(p), .p = p}, options, observer);
}

} // namespace matrigrate::run
