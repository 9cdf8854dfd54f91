#pragma once

#include "apps/export/layers.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace matrigrate::apps {

struct MovieOptions {
  double fps = 30.0;              ///< pictures a second
  std::optional<double> seconds;  ///< that it takes; by default one for 15 min of the run
  int width = 1280, height = 720; ///< even numbers [pixel]
  bool follow = false;            ///< the view stays on the cell
  Layer layer = Layer::degradation;
};

/// @param text  "1280x720"
/// @throws UsageError if it is no size, or one that a movie cannot have
void set_size(MovieOptions& options, const std::string& text);

/// @throws InputOutputError naming the Debian packages of what is not installed: chromium, ffmpeg
void require_movie_tools();

/// Writes movie.mp4: the player's view, drawn by the page of the run in a browser without a window (viewer/README.md)
/// and encoded by ffmpeg. Times between stored frames are interpolated, as the player does.
/// @throws InputOutputError if a tool fails
void export_movie(const run::FinishedRun& run, const MovieOptions& options, const std::filesystem::path& folder);

} // namespace matrigrate::apps
