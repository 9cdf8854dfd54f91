#pragma once

#include "exchange/openvt.hpp"
#include "run/finished_run.hpp"
#include "run/folder_lock.hpp"
#include "study_plan/study.hpp"
#include "study_results/results.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The parts of the verb export.
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

// Exports that the page of the run draws in a browser without a window (viewer/drive.mjs).

struct DrawnOptions {
  std::string layer;                   ///< that the matrix is coloured by; empty: what the kind has by default
  std::string size = "1280x720";       ///< of movies and pictures of frames [pixel]
  bool follow = false;                 ///< the view of movies stays on the cell; that of frames does anyway
  bool whole = false;                  ///< frames show the whole matrix
  double fps = 30.0;                   ///< pictures a second
  std::optional<double> movie_seconds; ///< by default one for 15 min of the run
  std::vector<double> panel_times;     ///< of panel.svg [s]
  std::vector<std::size_t> frames;     ///< numbers of those that are drawn
};

/// What to draw.
struct DrawnKinds {
  bool movie = false, frames = false, panel = false;
  bool any() const { return movie || frames || panel; }
};

/// @throws UsageError if layer or size are none, or the run has no such layer: one of fibres where there are none
void require_drawable(const run::FinishedRun& run, const DrawnOptions& options);

/// @throws InputOutputError naming the Debian packages of what is not installed: nodejs, chromium; ffmpeg for movies
void require_drawing_tools(const DrawnKinds& kinds);

/// Writes movie.mp4, frame_0000.png and frame_0000.svg and so on, panel.svg.
/// @throws InputOutputError if a tool fails
void export_drawn(const run::FinishedRun& run, const DrawnKinds& kinds, const DrawnOptions& options,
                  const std::filesystem::path& folder);

/// The times of the frames of a run nearest to those of --panel [s].
/// @param times  "0 h, 1 h 30 min, 6 h"
/// @throws UsageError saying what cannot be read, or which time has no frame nearby
std::vector<double> panel_times(const run::FinishedRun& run, const std::string& times);

/// The numbers of the frames nearest to those of --times, each once; all without times.
/// @throws UsageError saying which time has no frame nearby
std::vector<std::size_t> frames_at(const run::FinishedRun& run, const exchange::Times& times);

// Exports that the Python package makes (python/matrigrate/exchange.py).

struct PythonKinds {
  bool ome_tiff = false, simularium = false;
  std::optional<double> pixel; ///< width of a pixel of the stack [um]; none: the spacing of the particles
  bool any() const { return ome_tiff || simularium; }
};

/// A Python that can make these kinds: $PYTHON, or the first of python3 and /usr/bin/python3 that has what they need;
/// empty if no kind is wanted.
/// @throws InputOutputError naming the Debian packages that are missing
std::string python_for(const PythonKinds& kinds);

/// Writes fields.ome.tif, run.simularium.
/// @param python  as python_for() found it
/// @throws InputOutputError with what Python says, if it fails
void export_by_python(const run::FinishedRun& run, const PythonKinds& kinds, const std::string& python,
                      const std::string& title, const std::filesystem::path& folder);

// Exports that other programs make.

/// A folder that is gone with all that is in it at the end of this object. What an export has left in it whose process
/// was killed goes before.
struct Scratch {
  std::filesystem::path path; ///< with a folder `made` in it
  run::FolderLock lock;

  explicit Scratch(const std::filesystem::path& in);
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch();
};

/// Runs a program to its end.   @param log  what it says   @return its exit code
int exit_code_of(const std::vector<std::string>& command, const std::filesystem::path& log);

/// The same.
/// @throws InputOutputError with the last line that it says, if it fails
void call(const std::vector<std::string>& command, const Scratch& scratch);

/// Moves what was made to a folder.
void move_made(const Scratch& scratch, const std::filesystem::path& to);

} // namespace matrigrate::apps
