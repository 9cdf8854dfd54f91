#pragma once

#include "apps/export/layers.hpp"

#include <filesystem>

namespace matrigrate::apps {

/// Writes contact_sheet.svg and path.svg.
void export_svg(const run::FinishedRun& run, const std::filesystem::path& folder);

/// Writes frame_0000.svg and frame_0000.png, ..., with one colour bar for all.
/// @throws InputOutputError if a tool fails
void export_pictures(const run::FinishedRun& run, Layer layer, const std::filesystem::path& folder);

} // namespace matrigrate::apps
