#pragma once

#include "observe/tracks.hpp"
#include "parameters/parameters.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace matrigrate::exchange {

// Tracks of several runs, for programs that read many tracks from one file.
// Test: tests/unit/exchange/tracks_test.cpp

/// The tracks of a run, and what it is among others.
struct RunTracks {
  std::string name;          ///< unique: of a run of a study its hash
  std::string condition;     ///< label of its point
  std::size_t replicate = 1; ///< from 1
  std::uint64_t seed = 0;
  std::vector<TrackRow> rows;                                  ///< of all its cells
  std::vector<std::pair<std::string, std::string>> settings{}; ///< of its point: "ecm.youngs_modulus", "50 Pa"
};

/// The times that are wanted of each run.
struct Times {
  std::optional<double> every; ///< all multiples of it up to the end of the run, > 0 [s]
  std::vector<double> list;    ///< without `every`: these, rising [s]; empty: all that there are
};

/// The rows of a run at some times, in the order of times.
/// @throws std::invalid_argument naming all times that no row has; nothing is interpolated; or if `every` is less than
/// any interval of the rows, or longer than the run
std::vector<TrackRow> rows_at(const RunTracks& run, const Times& times);

/// A row per position: Unique_ID, Condition, experiment_nb, Repeat, File_name, LABEL, ID, TRACK_ID, POSITION_X,
/// POSITION_Y, POSITION_Z [um], POSITION_T [s], FRAME, RADIUS [um]; without FRAME where the rows of a run are not
/// evenly spaced. CellTracksColab takes it as its table of spots, TrackMate's CSV importer and celltrackR choose
/// columns by name. A track is a cell of a run; TRACK_ID counts from 0 through all runs.
std::string spots_csv(std::span<const RunTracks> runs);

/// A row per track: Unique_ID, Condition, experiment_nb, Repeat, File_name, LABEL, TRACK_ID, NUMBER_SPOTS, TRACK_START,
/// TRACK_STOP [s]: CellTracksColab's table of tracks.
std::string tracks_csv(std::span<const RunTracks> runs);

// The paths of the cells for programs that analyse tracks. Test: tests/unit/exchange/tracks_test.cpp,
// tests/readers/tracks_reads.py

/// For celltrackR: columns id, t [s], x, y [um]. Read by read.tracks.csv(file, sep = ",", pos.columns = 3:4).
std::string celltrackr_csv(std::span<const TrackRow> rows);

/// As TrackMate exports spots: columns ID, TRACK_ID, POSITION_X, POSITION_Y, POSITION_Z [um], POSITION_T [s], FRAME,
/// RADIUS [um]; without FRAME, which counts frames of one interval, where the rows are not evenly spaced.
std::string trackmate_csv(std::span<const TrackRow> rows);

/// As TrackMate exports tracks to XML ("Export tracks to XML file"), one particle a cell; a detection's t is the number
/// of its row, as TrackMate's is that of the frame.
/// @throws std::invalid_argument if the rows are not evenly spaced
std::string trackmate_xml(std::span<const TrackRow> rows);

// The tables of OpenVT, the community that compares simulators of tissues on common reference models: positions of
// cells as its portal reads them, and its two records (github.com/OpenVT/OpenVTschema): of the simulation and of the
// simulator. Test: tests/unit/exchange/tracks_test.cpp, tests/readers/openvt_reads.py

/// Columns simID, time [s], cellID, cellType, x, y [um]. simID is the number of the run in their order, from 0; cellID
/// the number of the cell, from 1; cellType 0.
/// @param runs  at the times that are wanted (rows_at)
std::string openvt_csv(std::span<const RunTracks> runs);

/// What a record of simulations says besides their settings.
struct OpenVtModel {
  std::string title;
  std::string version; ///< of this program
  std::string updated; ///< "2026-01-31"
  Parameters base;     ///< what the settings of the runs differ from
};

/// The record of the simulations, in the form of OpenVT's records of simulations, as JSON: model_id, model_name,
/// simulator, description, input_files, output_files, parameters (those that differ from the defaults), and besides
/// them units, and simulations: simID, condition, replicate, seed, parameters.
std::string openvt_record(const OpenVtModel& model, std::span<const RunTracks> runs);

/// The record of this program in the form of OpenVT's global schema, as JSON: what it simulates, its formats.
std::string openvt_simulator(const std::string& version);

} // namespace matrigrate::exchange
