#pragma once

#include "io/run_files.hpp"

#include <span>
#include <string>

/// The report of a run as one HTML file that needs nothing else. Test: tests/unit/io/run_page_test.cpp
namespace matrigrate::io {

struct RunReport {
  std::string title;
  std::string status; ///< a sentence: how the run ended
  ReadOuts readouts;
  std::span<const TrackRow> rows;
  std::string contact_sheet; ///< SVG document
  std::string provenance;    ///< its line breaks are kept
};

/// Contact sheet, read-outs, and path, shape and protrusions over time. @return  the HTML document
std::string run_page(const RunReport& report);

} // namespace matrigrate::io
