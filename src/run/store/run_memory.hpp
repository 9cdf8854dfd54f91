#pragma once

#include "observe/cell_scene.hpp"
#include "observe/group.hpp"
#include "observe/health.hpp"
#include "observe/tracks.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Output state stored in a checkpoint, so that a resumed run writes the files that one without a break would have
/// written. Test: tests/unit/store/run_memory_test.cpp
namespace matrigrate::store {

struct RunMemory {
  std::vector<TrackRow> rows;    ///< of tracks.csv
  std::vector<HealthRow> health; ///< of health.csv
  std::vector<GroupRow> group;   ///< of group.csv
  HealthWatch watch;             ///< since the last row
  std::optional<HealthRow>
      last;          ///< of the checkpoint's state; resuming cannot recompute it, as it depends on the step before
  StepHealth counts; ///< since the start
  std::vector<observe::CellScene> scenes; ///< of the contact sheet
  std::vector<double> frames;             ///< times of all frames so far, also of those that were lost since [s]
  std::uint64_t trajectory = 0;           ///< fingerprint of the rows so far
  double march_wall_time = 0.0;           ///< spent in the steps [s]
};

/// As JSON text; parse_memory gives the same bits back.
std::string to_text(const RunMemory& memory);

/// @throws InputOutputError saying what is wrong
RunMemory parse_memory(const std::string& text);

} // namespace matrigrate::store
