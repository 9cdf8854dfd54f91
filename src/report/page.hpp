#pragma once

#include "draw/plot.hpp"

#include <string>
#include <vector>

/// A report as one HTML file that needs nothing else: no network, no script, pictures inside. Reads on a phone, on a
/// desktop and on paper. Test: tests/unit/report/page_test.cpp
namespace matrigrate::report {

/// One chapter of a report.
struct PageSection {
  std::string title;
  std::string summary; ///< one sentence
  bool holds = false;  ///< the verdict
  std::vector<std::vector<std::string>>
      check_rows; ///< quantity, measured, expected, tolerance, why this tolerance, verdict
  std::vector<std::string> remarks;
  std::vector<draw::Figure> figures;
};

/// The words of a verdict: "holds" or "does not hold".
std::string verdict(bool holds);

/// @param title       heading of the page
/// @param provenance  what made the numbers; its line breaks are kept
/// @return  the HTML document; all text is escaped, figures are taken as they are
/// @throws std::invalid_argument if a check row has not six fields or a figure holds no SVG element
std::string page(const std::string& title, const std::vector<PageSection>& sections, const std::string& provenance);

} // namespace matrigrate::report
