#pragma once

#include "exchange/openvt.hpp"
#include "run/finished_run.hpp"
#include "study_plan/study.hpp"
#include "study_results/results.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate::apps {

// Exports of tracks, of a run or of all runs of a study that are done.

/// The times that --times names: "every 10 min", "0 h, 1 h, 3 h", or none: all.
/// @throws UsageError naming all that cannot be read
exchange::Times wanted_times(const std::string& text);

/// The tracks of a run, as those of a study of one run.
exchange::RunTracks single_run(const run::FinishedRun& run);

/// The runs at these times.
/// @throws UsageError naming all runs and times that they lack
std::vector<exchange::RunTracks> at_times(std::vector<exchange::RunTracks> runs, const exchange::Times& times);

/// tracks_celltrackr.csv, tracks_trackmate.csv and tracks_trackmate.xml of a run. Warns of what the files for TrackMate
/// leave out where rows are not evenly spaced.
void write_tracks(const run::FinishedRun& run, const std::filesystem::path& to);

/// The runs without last rows that come too soon. Warns of them, and of runs whose rows are uneven otherwise.
std::vector<exchange::RunTracks> without_odd_ends(std::vector<exchange::RunTracks> runs);

/// What makes rows or frames evenly spaced, in a sentence.
/// @param interval  "output.track_interval"
std::string even_if(std::string_view interval, const Parameters& p);

/// openvt.csv, openvt.json, openvt_simulator.json.
/// @param runs  at the times that are wanted
void write_openvt(const std::vector<exchange::RunTracks>& runs, exchange::OpenVtModel model,
                  const std::filesystem::path& to);

/// What openvt.json says of a run, and of a study.
exchange::OpenVtModel openvt_model(const run::FinishedRun& run);
exchange::OpenVtModel openvt_model(const study::Study& study, const std::vector<study::Result>& results);

/// The parts of a list between commas, without the spaces around them; none of an empty text.
std::vector<std::string> items_of(const std::string& list);

/// A time with its unit, "1 h 30 min"; 0 needs none [s].
/// @throws std::invalid_argument saying what is wrong
double time_of(const std::string& text);

} // namespace matrigrate::apps
