#pragma once

#include <filesystem>

/// Pages in the user's browser. Test: tests/apps/open_test.cpp
namespace matrigrate::apps {

/// The page of a folder: report.html, or the newest report-<ID>.html that `reproduce` wrote; a page itself.
/// @throws InputOutputError if there is none, saying how to make one
std::filesystem::path page_of(const std::filesystem::path& folder);

/// Opens a page with xdg-open, unless there is no screen (neither DISPLAY nor WAYLAND_DISPLAY is set) or no such
/// command.
/// @return whether it was opened
bool open_in_browser(const std::filesystem::path& page);

} // namespace matrigrate::apps
