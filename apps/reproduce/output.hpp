#pragma once

#include "claims/claims.hpp"

#include <string>
#include <vector>

namespace matrigrate::apps {

/// The table for people. Where runs are not the paper's, that stands beside the verdict.
std::string reproduction_text(const std::vector<study::JudgedClaim>& rows);

/// How the runs of each study ended, the verdicts in a table, a line per row, and the bottom line.
std::string reproduction_table(const std::vector<study::JudgedClaim>& rows, const study::Evidence& evidence);

/// The table as JSON text: {setting, as_published, rows: [claim_json()]}.
/// @param as_published  whether replicates and parameters are the paper's; otherwise these are no verdicts on it
std::string reproduction_json(const std::vector<study::JudgedClaim>& rows, const std::string& setting,
                              bool as_published);

} // namespace matrigrate::apps
