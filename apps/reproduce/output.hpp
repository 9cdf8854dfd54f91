#pragma once

#include "apps/reproduce/figures.hpp"
#include "apps/reproduce/options.hpp"
#include "claims/claims.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace matrigrate::apps {

/// @param claims  that are judged
/// @throws InputOutputError naming the files that would be replaced and were not written by this program
void require_own_files(const ReproduceOptions& options, const std::vector<study::Claim>& claims);

/// Writes claims.csv (the table), claims-<id>.csv (every mean and condition) and report-<id>.html into the
/// folder. Runs that deviate from the paper's set-up are marked, in the column `caveat` and on the page.
/// @param command  that made the runs
void write_reproduction(const std::filesystem::path& folder, const std::string& id,
                        const std::vector<study::JudgedClaim>& rows, const study::Evidence& evidence,
                        const ReproducedFigures& figures, const std::string& setting, const std::string& command);

/// The table for people. Where runs are not the paper's, that stands beside the verdict.
std::string reproduction_text(const std::vector<study::JudgedClaim>& rows);

/// How the runs of each study ended, the verdicts in a table, a line per row, and the bottom line.
std::string reproduction_table(const std::vector<study::JudgedClaim>& rows, const study::Evidence& evidence);

/// The table as JSON text: {setting, as_published, rows: [claim_json()]}.
/// @param as_published  whether replicates and parameters are the paper's; otherwise these are no verdicts on it
std::string reproduction_json(const std::vector<study::JudgedClaim>& rows, const std::string& setting,
                              bool as_published);

} // namespace matrigrate::apps
