#pragma once

#include "observe/readouts.hpp"
#include "parameters/parameters.hpp"
#include "run/observer.hpp"
#include "run/run_record.hpp"
#include "state/state.hpp"
#include "store/run_memory.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// One run, from its start or a checkpoint to its end, with all files of its
/// folder. Test: tests/unit/run/simulate_test.cpp, tests/apps/run_test.cpp
namespace matrigrate::run {

/// Where a branch leaves its run: up to then the run's own parameters hold.
struct BranchPoint {
  Parameters p;
  double until; ///< [s]
};

/// Where a run starts, and what has been written of it already.
struct RunStart {
  State s;
  Parameters p;
  store::RunMemory memory{};                        ///< empty: a new run
  std::optional<BranchPoint> before{};              ///< of a branch
  std::vector<Json> lineage{};                      ///< restarts and branches, oldest first
  std::filesystem::path frames_from{};              ///< the folder whose frames a branch takes over
  std::string scenario{};                           ///< its name; empty: that of the command line
  std::vector<std::vector<std::string>> commands{}; ///< that started it, oldest first; none: the command line
  double earlier_wall_time = 0.0;                   ///< of the runs that this one continues [s]
  std::uint64_t steps_without_bias = 0;             ///< of the run so far (RunRecord)
};

/// How a run is carried out.
struct RunOptions {
  std::filesystem::path folder;                                     ///< exists, but for a branch
  double wall_time_limit = std::numeric_limits<double>::infinity(); ///< from the call on [s]
  std::vector<std::string> command_line;                            ///< for run.json
  std::string_view page_template;                                   ///< of report.html (report/run_page.hpp);
                                                                    ///< empty: none is written
  bool folder_is_kept = true; ///< else it is removed afterwards, and how the run ended says so
};

/// The outcome of a run.
struct RunOutcome {
  std::filesystem::path folder;
  RunEnd end = RunEnd::completed;
  bool computed = true; ///< false: the run was done already, and the members
                        ///< below are empty but for `record`
  Json record;          ///< run.json
  std::string sentence; ///< how it ended, for people
  Parameters p;
  std::vector<CellResult> cells; ///< results of each
};

/// Computes to the end, a request to stop, the limit of wall time or a
/// numerical failure, and writes the files of the run.
/// @throws InputOutputError naming what could not be written, and what is safe
RunOutcome run(RunStart start, const RunOptions& options, RunObserver& observer);

} // namespace matrigrate::run
