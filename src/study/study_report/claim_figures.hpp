#pragma once

#include "claims/evidence.hpp"
#include "report/verdict_page.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// What the page of `matrigrate reproduce` draws. Test: tests/apps/reproduce_test.cpp, viewer/tests/kept_page.test.ts
namespace matrigrate::study {

/// The study whose fibres are drawn, and the label of the point, with two protrusions.
inline constexpr std::string_view fibre_study = "kept-protrusions-fibres";
inline constexpr std::string_view fibre_point = "n_prot 2";

struct ClaimFigures {
  std::map<std::string, std::vector<report::Plot>> plots;           ///< by the id of the row that they belong to
  std::map<std::string, std::vector<draw::Picture>> pictures;       ///< likewise
  nlohmann::ordered_json studies = nlohmann::ordered_json::array(); ///< as report::VerdictReport has them
};

/// Plots of verification cases, studies and the stress of fibres (Figs 2, 4, 6, 9, 11 to 13), all from tables: those of
/// options.from, or those that lie beside the runs. Of runs it first writes shapes.csv into the folders
/// of the studies, and fibre-stress.csv, of one run with two protrusions among fibres, beside them. Writes
/// fibre-stress.svg.
/// @throws InputOutputError if frames or a table cannot be read
ClaimFigures claim_figures(const Evidence& evidence, const EvidenceOptions& options);

} // namespace matrigrate::study
