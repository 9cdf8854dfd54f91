#pragma once

#include "base/failure.hpp"
#include "exchange/run_tracks.hpp"
#include "run/status.hpp"
#include "study_plan/study.hpp"

#include <array>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The results of the runs of a study, from the files of a study folder. They may be read at any time.
/// Test: tests/unit/study_results/comparison_test.cpp, tests/apps/study_test.cpp
namespace matrigrate::study {

inline constexpr std::size_t largest_table = std::size_t{1} << 28U; ///< bytes that are read

/// The folder of a run, and the file that its output goes to while it is computed.
std::filesystem::path run_folder(const std::filesystem::path& study_folder, const Run& run);
std::filesystem::path run_log(const std::filesystem::path& study_folder, const Run& run);

/// How far a run of a study is: unfinished if it has begun and has not ended, running if a process is computing it.
/// A damaged one was done, but its files are no longer what they were: results() tells.
enum class RunState { missing, unfinished, running, done, failed, interrupted, damaged };

/// Their names, in their order.
inline constexpr std::array<std::string_view, 7> run_states{"missing", "unfinished",  "running", "done",
                                                            "failed",  "interrupted", "damaged"};
std::string_view to_string(RunState state);

/// How a run stands.
struct Standing {
  RunState status = RunState::missing; ///< running is for those who know of processes
  std::string reason;                  ///< why it is not done
  std::optional<FailureCause> cause;   ///< of a numerical failure; none in records of version 0.1.0
  std::string trajectory_hash;
  std::vector<std::string> programs; ///< that computed it, oldest first: "0.1.0 (1234abcd)"
  std::string end;                   ///< when it ended: "2026-01-31T12:00:00Z"; empty while it has not
  double wall_time = 0.0;            ///< [s]

  bool done() const { return status == RunState::done; }
  /// True if the run would fail again: a numerical failure is the same on every machine. A run without a recorded
  /// cause is computed again.
  bool failed_for_good() const { return status == RunState::failed && cause.has_value(); }
  /// Whether the run has come to its end: computing it again would change nothing.
  bool ended() const { return done() || failed_for_good(); }
};

/// A run whose record or summary is missing or no JSON counts as unfinished, with the reason.
Standing standing(const std::filesystem::path& study_folder, const Run& run);

/// A run with its read-outs.
struct Result {
  Run run;
  Standing standing;
  std::vector<double> readouts; ///< in the order of all_readouts(); NaN where not defined or the run is not done
};

/// Whether a run ended early because a cell came to the clamped rim of the matrix: those cells were the fast ones.
bool ended_at_rim(const Result& r);

/// Runs of each point that ended at the rim.
std::vector<std::size_t> lost_at_rim(const Study& study, const std::vector<Result>& results);

/// By how much reproduce, and the advice of rim_text, makes the disc larger.
inline constexpr double larger_disc = 1.5;

/// "9 of 12 runs ended at the rim of the matrix (50 Pa: 3 of 6; 200 Pa: 6 of 6): means are of the slower cells.
/// ...": what that means, and what to do; empty if none did.
std::string rim_text(const Study& study, const std::vector<Result>& results);

/// The builds of the program that made the runs that are done, or parts of them, "0.2.0 (9a32bbbb)", in alphabetical
/// order.
std::vector<std::string> programs_of(const std::vector<Result>& results);

/// That runs of several builds are compared, and what it means; empty if one build made all.
std::string programs_text(const std::vector<Result>& results);

/// The read-outs in the folder of a run that is done, in the order of all_readouts(); NaN where not defined.
/// @throws InputOutputError if a table cannot be read, or is not what the record or the checkpoint of the run says
std::vector<double> readouts_of(const std::filesystem::path& run_folder);

/// All runs, point by point. A run that is done but has a damaged table is `damaged`, with the reason and what helps.
std::vector<Result> results(const Study& study, const std::vector<Run>& runs,
                            const std::filesystem::path& study_folder);

/// Results, with those of `by` that have ended in the place of those of the same runs that are lost.
std::vector<Result> replaced(std::vector<Result> results, const std::vector<Result>& by, bool (*lost)(const Result&));

/// Results, with those that were kept elsewhere in the place of those that have not ended.
std::vector<Result> with_kept(std::vector<Result> results, const std::vector<Result>& kept);

/// The defined values of a read-out over the runs of a point that are done.
/// @throws std::invalid_argument if there is no such read-out
std::vector<double> sample(const std::vector<Result>& results, std::size_t point, std::string_view readout);

/// The columns that tables of a study have for its swept parameters, with the unit at their end, and what stands in
/// them at a point: the number in that unit, or the word of a choice.
std::vector<std::string> swept_columns(const Study& study);
std::vector<std::string> swept_values(const Study& study, const Point& point);

/// results.csv: a row per run. Swept parameters in the unit that ends their column's name; nothing that depends on the
/// machine, so that two computations of a study can be compared byte by byte.
std::string results_csv(const Study& study, const std::vector<Result>& results);

/// "Pa" -> "_Pa", "1/s" -> "_per_s", "nN s/um" -> "_nN_s_per_um"; nothing for a ratio.
std::string unit_suffix(std::string_view unit);

/// One list of several.
template <class T>
std::vector<T> concatenated(std::initializer_list<std::vector<T>> parts) {
  std::vector<T> all;
  for (const std::vector<T>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

// From the tables of a study alone, so that claims can be judged anew by what was kept of runs that are no longer
// there. Test: tests/unit/study_results/read_results_test.cpp

/// All rows of results.csv, for runs that are no longer there, point by point: name, seed, status, fingerprint and
/// read-outs of each run. Read-outs that came after the table are NaN.
/// @param name  stands for the file in messages
/// @throws InputOutputError with the first 20 faults, by line and column, if the text is no results.csv of this study:
///         no table, a column missing, unknown or there twice, a field that is no number, a label, parameter or
///         duration that is none of the study's, or a number of runs other than the study's
std::vector<Result> read_results(const Study& study, std::string_view csv, const std::string& name);

/// Numbers of a table by the label of the point and the replicate, which is "" in tables without.
using RowsByRun = std::map<std::pair<std::string, std::string>, std::vector<std::vector<double>>>;

/// The named columns of a table whose rows belong to runs or points, and, where it has several cells, these behind
/// them.
/// @throws InputOutputError if a column is not there
RowsByRun rows_by_run(std::string_view csv, const std::vector<std::string_view>& columns);

// The tracks of a study in one table. Test: tests/apps/export_study_test.cpp

/// The rows of tracks.csv of all runs that are done, point by point, behind the columns run, label, swept parameters,
/// replicate and seed of results.csv; empty if none is done. What only runs with a nucleus have is empty in the others.
/// @throws InputOutputError if tracks.csv of one of them cannot be read, is damaged, or has columns of its own
std::string tracks_csv(const Study& study, const std::vector<Result>& results,
                       const std::filesystem::path& study_folder);

/// The tracks of all runs that are done, in the order of results: times, cells, centres of mass and areas alone.
/// @throws InputOutputError as tracks_csv
std::vector<exchange::RunTracks> run_tracks(const Study& study, const std::vector<Result>& results,
                                            const std::filesystem::path& study_folder);

} // namespace matrigrate::study
