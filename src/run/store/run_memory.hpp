#pragma once

#include "observe/health.hpp"
#include "observe/tracks.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Output state stored in a checkpoint, so that a resumed run writes the files that one without a break would have
/// written. Of the tables it holds length and fingerprint; their rows are in the files.
/// Test: tests/unit/store/store_test.cpp
namespace matrigrate::store {

struct RunMemory {
  std::map<std::string, std::string> tables; ///< text of each table so far, by the name of its file
  std::vector<TrackRow> rows;                ///< those of tracks.csv
  std::vector<GroupRow> group;               ///< those of group.csv
  HealthWatch watch;                         ///< since the last row of health.csv
  StepHealth counts;                         ///< since the start
  std::uint64_t step = 0;                    ///< of the checkpoint
  double force_imbalance = undefined;        ///< of that step [-]
  std::vector<double> frames;                ///< times of all frames so far, also of those that were lost since [s]
  std::uint64_t trajectory = 0;              ///< fingerprint of the rows so far
  double march_wall_time = 0.0;              ///< spent in the steps [s]
};

/// As JSON text; parse_memory gives the same bits back.
std::string to_text(const RunMemory& memory);

/// @param folder  holds the tables; rows that were added to them later are left out
/// @throws InputOutputError saying what is wrong, or which table has been changed since
RunMemory parse_memory(const std::string& text, const std::filesystem::path& folder);

/// Compares the tables in a folder with what a checkpoint says of them, and requires that later rows are whole lines.
/// @param text  Checkpoint::memory
/// @throws InputOutputError naming the first table that is missing, cut or changed
void require_whole_tables(const std::string& text, const std::filesystem::path& folder);

} // namespace matrigrate::store
