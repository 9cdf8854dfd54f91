#pragma once

#include "apps/export/layers.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace matrigrate::apps {

/// The frames of a run nearest to some times, as places in its film.
/// @param times  "0 h, 1 h 30 min, 6 h"; a number without a unit is hours
/// @throws UsageError saying what cannot be read, or which time has no frame nearby
std::vector<std::size_t> frames_at(const run::FinishedRun& run, const std::string& times);

/// Writes panel.svg: frames side by side at one scale, with one colour bar.
void export_panel(const run::FinishedRun& run, const std::vector<std::size_t>& frames, Layer layer,
                  const std::filesystem::path& folder);

} // namespace matrigrate::apps
