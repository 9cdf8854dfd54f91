#pragma once

#include "observe/readouts.hpp"
#include "parameters/parameters.hpp"
#include "run/cadence.hpp"
#include "run/folder_lock.hpp"
#include "run/run_record.hpp"
#include "simulation/workspace.hpp"
#include "state/state.hpp"
#include "store/frame_log.hpp"
#include "store/row_file.hpp"
#include "store/run_memory.hpp"
#include "store/saved_frames.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate::run {

/// The files of a run. Rows reach the disk as they come, and checkpoints at intervals, so that a run that is ended at
/// any moment can be resumed with what it has computed. Test: tests/unit/run/simulate_test.cpp, tests/apps/run_test.cpp
class RunFolder {
public:
  /// Writes scenario.resolved.toml, run.json and the tables with the rows that there are already. Removes temporary
  /// files of processes that were killed and, for a run from the start, the files of an older run.
  /// @param folder  exists; it is locked against other processes
  /// @param memory  output state of a resumed run; none for a new run
  /// @param from    the folder whose frames a branch takes over; empty: `folder`
  RunFolder(std::filesystem::path folder, const Parameters& p, const RunRecord& record, const State& s,
            store::RunMemory memory, const std::filesystem::path& from);

  /// Writes what is due at the start of a new run.
  void begin(const State& s, const Workspace& w);

  /// Writes what is due after a step.
  /// @throws NumericalFailure if the run must not go on (observe/health.hpp, alarm)
  void see(const State& s, const Workspace& w, const RunRecord& record);

  /// Writes checkpoint.h5, if the run may go on.
  /// @param keep  writes a second file, named by its time, for branches
  /// @throws NumericalFailure if the run must not go on; checkpoint.h5 then stays the last good one
  void write_checkpoint(const State& s, const Workspace& w, double march_wall_time, bool keep = false);

  /// Removes fields.part, which only resuming needs. Call it after run.json says that the run is done.
  void remove_log();

  /// Switches the checkpoints at intervals on or off; they are on by default.
  void keep_checkpoints(bool keep) { m_keeps_checkpoints = keep; }

  /// Writes the row, the snapshot and the frame of the last state, as far as they have not been due.
  /// @param stopped  true if stopped before the end: then no snapshot, since a resumed run would keep it
  void see_last(const State& s, const Workspace& w, bool stopped);

  /// Writes all that is made at the end: fields.h5, read-outs, contact sheet and report.
  /// @param status  a sentence on how the run ended, for the report
  /// @param failed  whether a picture of the moment is wanted
  /// @param record  for the report
  /// @param page_template  of the report; empty: none is written
  void finish(const State& s, const std::string& status, bool failed, const RunRecord& record,
              std::string_view page_template);

  /// Writes run.json.
  void write_record(const RunRecord& record) const;

  /// Frames of earlier parts of the run that could not be taken over.
  store::LostFrames lost_frames() const;

  const std::vector<CellResult>& results() const { return m_results; } ///< of the cells, after finish()
  std::string trajectory_hash() const;                                 ///< so far
  std::optional<double> safe_until() const { return m_safe_until; }    ///< time of the last checkpoint [s]

private:
  /// @throws NumericalFailure if the computation must not go on
  void require_health(const State& s, const HealthRow& row) const;
  HealthRow health_row(const State& s, const Workspace& w, HealthWatch& watch) const;
  void add_row(const State& s, const Workspace& w);
  void add_ended(const State& s);
  void add_snapshot(const State& s, const Workspace& w);
  void add_frame(const State& s, const Workspace& w);
  void open_log(const State& s, const std::filesystem::path& from);
  void write_pictures(const State& s, bool failed) const;

  std::filesystem::path m_folder;
  FolderLock m_lock;
  Parameters m_p;
  store::RunMemory m_memory;
  std::vector<std::size_t> m_ended; ///< protrusions of each cell written so far
  std::optional<store::RowFile> m_tracks;
  std::optional<store::RowFile> m_protrusions;
  std::optional<store::RowFile> m_health;
  std::optional<store::RowFile> m_group; ///< of several cells
  std::optional<store::FrameLog> m_frames;
  Cadence m_row_cadence;
  Cadence m_snapshot_cadence;
  Cadence m_frame_cadence;
  Cadence m_checkpoint_cadence;
  Cadence m_kept_cadence;
  std::vector<double> m_frame_times; ///< of the frames in the log [s]
  bool m_keeps_checkpoints = true;
  std::optional<double> m_safe_until;
  std::vector<CellResult> m_results;
};

} // namespace matrigrate::run
