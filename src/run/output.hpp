#pragma once

#include "base/parallel.hpp"
#include "observe/readouts.hpp"
#include "parameters/parameters.hpp"
#include "run/run_record.hpp"
#include "simulation/workspace.hpp"
#include "state/state.hpp"
#include "store/run_memory.hpp"
#include "tables/table.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate::run {

/// What the outputs of a run share.
struct RunSoFar {
  std::filesystem::path folder;
  Parameters p;
  const Parameters& now; ///< of the last step
  store::RunMemory memory;
  std::filesystem::path frames_from; ///< the folder whose frames the run takes over
  std::vector<double> frame_times{}; ///< of the frames in the log, those that were lost left out [s]
  Behind behind{};                   ///< what is written while the next steps are computed

  /// The end of a table's file, to which rows are added.
  std::shared_ptr<store::RowFile> table(const std::string& name, const std::vector<std::string_view>& columns) {
    return std::make_shared<store::RowFile>(folder / name, columns, memory.tables[name]);
  }
};

/// How a run ended, for the files that are written then.
struct RunFinish {
  const State& s;
  std::string status; ///< a sentence on how the run ended
  const RunRecord& record;
  std::string_view page_template;     ///< of the report; empty: none is written
  std::vector<CellResult> cells = {}; ///< results of each
};

inline constexpr double each_step = 1e-9; ///< an interval shorter than any step [s]

/// Files of a run that are written together.
struct Output {
  double interval = 0.0; ///< 0: `write` is not called [s]
  /// Writes what is due now. Called once more at the end of the run, where nothing must be written twice.
  /// @throws NumericalFailure if the run must not go on (observe/health.hpp, alarm)
  std::function<void(const State&, const Workspace&)> write{};
  std::function<void()> flush{};                      ///< before a checkpoint that counts on what was written, behind
  std::function<void(const RunFinish&)> finish{};     ///< writes what is made at the end
  std::function<void()> remove_what_resuming_needs{}; ///< after run.json says that the run is done
};

/// An output by its files, and what makes it.
struct OutputKind {
  std::string_view folder;                            ///< of its files, within that of the run
  std::string_view names;                             ///< of its files, as a regular expression (ECMAScript)
  Output (*begin)(RunSoFar&, const State&) = nullptr; ///< none: written by others than RunFolder's list
};

/// All outputs, in the order in which they are written.
std::span<const OutputKind> output_kinds();

/// The signs of health at a state. The step before a checkpoint is not known to a run that goes on from there.
/// @param watch  of the steps since the last row
HealthRow health_row(const RunSoFar& run, const State& s, const Workspace& w, HealthWatch& watch);

/// @throws NumericalFailure if the computation must not go on
void require_health(const RunSoFar& run, const State& s, const HealthRow& row);

} // namespace matrigrate::run
