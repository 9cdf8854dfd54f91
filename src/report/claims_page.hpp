#pragma once

#include "draw/plot.hpp"
#include "report/run_page.hpp"

#include <string>
#include <vector>

/// A report on claims as one HTML file that needs nothing else, never wider than its window.
/// Test: tests/unit/report/claims_page_test.cpp
namespace matrigrate::report {

/// A claim with what became of it.
struct ClaimSection {
  std::string id;
  std::string sentence;
  std::string published; ///< the paper's numbers; empty where it gives none
  std::string kind{};    ///< "calibration", "predicted" or "verification"
  std::string brief{};   ///< ours, in a line
  std::string why_not{}; ///< in a line; empty if it holds
  std::string verdict;   ///< "holds", "does not hold" or "undecided"
  std::string caveat;    ///< beside the verdict: "not the paper's runs"; empty for nothing
  std::vector<std::string> ours;
  std::vector<std::string> conditions; ///< each with its statistic
  std::vector<draw::Figure> figures;
};

/// @param facts       command, date, version, runs done, at the top of the page
/// @param setting     how the runs were made, at the top of the page
/// @param provenance  what made the numbers; its line breaks are kept
/// @return  the HTML document; all text is escaped, figures are taken as they are
/// @throws std::invalid_argument if a figure holds no SVG element
std::string claims_page(const std::string& title, const std::vector<Fact>& facts, const std::string& setting,
                        const std::vector<ClaimSection>& claims, const std::string& provenance);

} // namespace matrigrate::report
