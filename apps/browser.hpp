#pragma once

#include <filesystem>

/// Pages in the user's browser. Test: tests/apps/open_test.cpp
namespace matrigrate::apps {

/// Opens a page with xdg-open, unless there is no screen (neither DISPLAY nor WAYLAND_DISPLAY is set) or no such
/// command.
/// @return whether it was opened
bool open_in_browser(const std::filesystem::path& page);

/// Opens a page so, or prints where it is.
void show_page(const std::filesystem::path& page, bool only_print);

} // namespace matrigrate::apps
