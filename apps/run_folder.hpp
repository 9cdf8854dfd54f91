#pragma once

#include "apps/run_record.hpp"
#include "io/cell_scene.hpp"
#include "io/row_file.hpp"
#include "io/trajectory_hash.hpp"
#include "observe/health.hpp"
#include "observe/readouts.hpp"
#include "observe/tracks.hpp"
#include "parameters/parameters.hpp"
#include "simulation/workspace.hpp"
#include "state/state.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace matrigrate::apps {

/// Tells when the next of a regular event is due. The first one is due at 0.
class Cadence {
public:
  /// @param interval  [s]   @param step  the time step, which decides how exactly times agree [s]
  Cadence(double interval, double step) : m_interval(interval), m_slack(1e-6 * step) {}

  /// Whether one is due at t; if so, the next one is due at the next multiple of the interval.
  bool due(double t);

private:
  double m_interval;
  double m_slack;
  double m_next = 0.0;
};

/// The files of a run. Rows reach the disk as they come, so that a run that is killed keeps what it has computed.
class RunFolder {
public:
  /// Writes scenario.resolved.toml, run.json, the headers of the tables and what is there at the start.
  /// @param folder  exists
  RunFolder(std::filesystem::path folder, const Parameters& p, const RunRecord& record, const State& s,
            const Workspace& w);

  /// Writes what is due after a step.
  void see(const State& s, const Workspace& w, const RunRecord& record);

  /// Writes the rows and the snapshot of the last state, read-outs, contact sheet and report.
  /// @param status  a sentence on how the run ended, for the report
  void finish(const State& s, const Workspace& w, const std::string& status);

  /// Writes run.json.
  void write_record(const RunRecord& record) const;

  const ReadOuts& readouts() const { return m_readouts; }             ///< after finish()
  std::string trajectory_hash() const { return m_trajectory.text(); } ///< so far

private:
  void add_row(const State& s, const Workspace& w);
  void add_ended(const State& s);
  void add_snapshot(const State& s, const Workspace& w);

  std::filesystem::path m_folder;
  Parameters m_p;
  io::RowFile m_tracks;
  io::RowFile m_protrusions;
  io::RowFile m_health;
  io::TrajectoryHash m_trajectory;
  HealthWatch m_watch;
  std::vector<TrackRow> m_rows;
  std::size_t m_ended = 0; ///< protrusions written so far
  std::vector<io::CellScene> m_scenes;
  Cadence m_row_cadence;
  Cadence m_snapshot_cadence;
  ReadOuts m_readouts;
};

} // namespace matrigrate::apps
