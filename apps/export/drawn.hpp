#pragma once

#include "exchange/run_tracks.hpp"
#include "run/finished_run.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace matrigrate::apps {

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

} // namespace matrigrate::apps
