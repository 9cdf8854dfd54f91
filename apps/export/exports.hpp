#pragma once

#include "run/finished_run.hpp"
#include "run/folder_lock.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The parts of the verb export.
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
