#pragma once

#include "run/finished_run.hpp"

#include <filesystem>
#include <string>

namespace matrigrate::apps {

/// What particles are coloured by.
enum class Layer { displacement, von_mises, pressure, fibre_von_mises };

/// @throws UsageError if there is no layer of that name
Layer layer_of(const std::string& name);

/// @throws UsageError if the run has no such layer: one of fibres where there are none
void require_layer(const run::FinishedRun& run, Layer layer);

/// @throws InputOutputError if rsvg-convert is not installed, or ffmpeg where a movie is wanted
void require_tools(bool movie);

/// Writes contact_sheet.svg and path.svg.
void export_svg(const run::FinishedRun& run, const std::filesystem::path& folder);

/// Writes frame_0000.svg and frame_0000.png, ..., with one colour bar for all.
/// @throws InputOutputError if a tool fails
void export_pictures(const run::FinishedRun& run, Layer layer, const std::filesystem::path& folder);

/// Writes movie.mp4 of such pictures, which are made in a temporary folder.
/// @throws InputOutputError if a tool fails
void export_movie(const run::FinishedRun& run, Layer layer, const std::filesystem::path& folder);

} // namespace matrigrate::apps
