#pragma once

#include "exchange/run_tracks.hpp"
#include "parameters/parameters.hpp"

#include <span>
#include <string>

/// The tables of OpenVT, the community that compares simulators of tissues on common reference models: positions of
/// cells as its portal reads them, and its two records (github.com/OpenVT/OpenVTschema): of the simulation and of the
/// simulator. Test: tests/unit/exchange/tracks_test.cpp, tests/readers/openvt_reads.py
namespace matrigrate::exchange {

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
