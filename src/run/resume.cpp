#include "run/resume.hpp"

#include "run/stopped_run.hpp"
#include "simulation/start.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace matrigrate::run {

namespace {

RunOutcome done_before(const RunOptions& options, const Json& record, RunObserver& observer) {
  restore_scenario(options.folder, observer);
  return {.folder = options.folder, .computed = false, .record = record, .sentence = {}, .p = {}, .cells = {}};
}

RunOutcome resume_from(FoundCheckpoint last, const RunOptions& options, const Json& record, std::optional<int> threads,
                       RunObserver& observer) {
  const FoundCheckpoint found = before_shortened_end(std::move(last), options.folder);
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
  return resume_from(last_checkpoint(options.folder, from.previous), options, record, from.threads, observer);
}

RunOutcome resume(const RunOptions& options, const Parameters& p, RunObserver& observer) {
  const Json record = record_of(options.folder);
  if (is_done(options.folder, record, observer)) return done_before(options, record, observer);
  if (has_checkpoint(options.folder))
    return resume_from(whole_checkpoint(options.folder, observer), options, record, p.run.threads, observer);
  return run({.s = initial_state(p), .p = p}, options, observer);
}

} // namespace matrigrate::run
