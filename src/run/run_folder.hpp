#pragma once

#include "run/cadence.hpp"
#include "run/folder_lock.hpp"
#include "run/output.hpp"
#include "simulation/simulation.hpp"
#include "store/saved_frames.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace matrigrate::run {

/// The folder of a run: its outputs, its record and its checkpoints. What is written reaches the disk as it comes, and
/// checkpoints at intervals, so that a run that is ended at any moment can be resumed with what it has computed.
/// Test: tests/unit/run/simulate_test.cpp, tests/apps/run_test.cpp
class RunFolder {
public:
  /// Writes scenario.resolved.toml and run.json, and begins the outputs with what there is already. Removes temporary
  /// files of processes that were killed and, for a run from the start, the files of an older run.
  /// @param folder  exists; it is locked against other processes
  /// @param memory  output state of a resumed run; none for a new run
  /// @param from    the folder whose frames a branch takes over; empty: `folder`
  RunFolder(const std::filesystem::path& folder, const Parameters& p, const RunRecord& record,
            const Simulation& simulation, store::RunMemory memory, const std::filesystem::path& from);
  RunFolder(const RunFolder&) = delete; // the outputs refer to m_run
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder();

  /// Writes what is due at the start of a new run.
  void begin(const State& s, const Workspace& w);

  /// Writes what is due after a step, frames and checkpoints behind the next ones.
  /// @throws InputOutputError if it cannot be written, or what was due before
  /// @throws NumericalFailure if the run must not go on (observe/health.hpp, alarm)
  void see(const State& s, const Workspace& w, const RunRecord& record);

  /// Counts a step after which nothing is due but what see_last() writes.
  void note_step(const Workspace& w);

  /// Writes checkpoint.h5, if the run may go on, behind the next steps.
  /// @param keep  writes a second file, named by its time, for branches
  /// @throws NumericalFailure if the run must not go on; checkpoint.h5 then stays the last good one
  void write_checkpoint(const State& s, const Workspace& w, double march_wall_time, bool keep = false);

  /// Whether checkpoints are written at their intervals; they are, unless told otherwise.
  void keep_checkpoints(bool keep) { m_keeps_checkpoints = keep; }

  /// Until all that is due is written.   @throws InputOutputError if it cannot be
  void wait() { m_run.behind.wait(); }

  /// Writes what the outputs hold of the last state, as far as it has not been due.
  void see_last(const State& s, const Workspace& w);

  /// Writes all that is made at the end.
  /// @return the results of the cells
  std::vector<CellResult> finish(RunFinish end);

  /// Removes what only resuming needs. Call it after run.json says that the run is done.
  void tidy();

  /// Writes run.json.
  void write_record(const RunRecord& record) const;

  /// Frames of earlier parts of the run that could not be taken over.
  store::LostFrames lost_frames() const;

  std::string trajectory_hash() const; ///< so far

  /// Time of the last checkpoint, once it is written [s].
  std::optional<double> safe_until() const;

private:
  struct Regular {
    Output output;
    Cadence cadence;
  };

  void write_due(const State& s, const Workspace& w);
  std::string text_of(const RunRecord& record) const; ///< run.json

  RunSoFar m_run;
  FolderLock m_lock;
  std::vector<Regular> m_outputs;
  Cadence m_checkpoint_cadence;
  Cadence m_kept_cadence;
  bool m_keeps_checkpoints = true;
  std::optional<double> m_safe_until;
};

} // namespace matrigrate::run
