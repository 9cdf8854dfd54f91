#pragma once

#include "draw/plot.hpp"

#include <string>
#include <vector>

/// What all reports have in common. Test: tests/unit/report/page_test.cpp
namespace matrigrate::report {

/// From the start of the document to its heading.
std::string page_head(const std::string& title);

/// Pictures side by side where there is room; nothing if there are none.
/// @param prefix  sets the ids inside of the pictures apart from those of others on the page
/// @throws std::invalid_argument if a figure holds no SVG element
std::string figures_html(const std::vector<draw::Figure>& figures, const std::string& prefix);

/// The chapter on what made the numbers, and the end of the document.
std::string page_end(const std::string& provenance);

} // namespace matrigrate::report
