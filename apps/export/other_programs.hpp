#pragma once

#include "run/finished_run.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The kinds of the verb export that other programs make.
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

} // namespace matrigrate::apps
