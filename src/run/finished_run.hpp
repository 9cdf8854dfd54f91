#pragma once

#include "observe/frame.hpp"
#include "observe/readouts.hpp"
#include "parameters/parameters.hpp"
#include "store/run_memory.hpp"
#include "store/saved_frames.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace matrigrate::run {

/// What the files of a run hold, up to its last checkpoint; frames up to the last one.
struct FinishedRun {
  std::filesystem::path folder;
  Parameters p;
  nlohmann::ordered_json record; ///< run.json
  double t = 0.0;                ///< of the checkpoint [s]
  store::RunMemory memory;
  std::vector<CellResult> cells;   ///< results of each
  std::vector<double> frame_times; ///< of the frames written up to the checkpoint [s]
  observe::Film film;              ///< those that are still whole, and later ones
  std::string trouble;             ///< why fields.h5 was refused; empty if it was not, or was not needed
};

/// The scenario is taken from the checkpoint.
/// @throws InputOutputError if the folder holds no run, or one of its files cannot be read
FinishedRun read_run(const std::filesystem::path& folder);

/// Frames that the run wrote up to its last checkpoint, and that its film lacks.
store::LostFrames lost_frames(const FinishedRun& run);

/// What the page of the run shows (viewer/src/contract.ts).
nlohmann::ordered_json page_data(const FinishedRun& run);

// Read-outs of runs by versions up to 0.2.0, whose summary.json lacks those that claims need.
// Test: tests/apps/other_version_test.cpp

/// Sets these read-outs from the tables of a run; of several cells their mean over those for which they are defined.
/// @param values  in the order of readout_table()
/// @throws InputOutputError if a table cannot be read
void add_from_tables(const std::filesystem::path& folder, std::span<double> values);

} // namespace matrigrate::run
