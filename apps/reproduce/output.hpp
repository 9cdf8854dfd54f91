#pragma once

#include "apps/reproduce/figures.hpp"
#include "apps/reproduce/options.hpp"
#include "claims/claims.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace matrigrate::apps {

/// A row of the table of claims.
using ReproducedRow = study::JudgedClaim;

/// @param claims  that are judged
/// @throws InputOutputError naming the files that would be replaced and were not written by this program
void require_own_files(const ReproduceOptions& options, const std::vector<const study::Claim*>& claims);

/// Writes claims.csv (the table), claims-<id>.csv (every mean and condition) and report-<id>.html into the
/// folder. Runs that deviate from the paper's set-up are marked, in the column `caveat` and on the page.
/// @param command  that made the runs
void write_reproduction(const std::filesystem::path& folder, const std::string& id,
                        const std::vector<ReproducedRow>& rows, const study::Evidence& evidence,
                        const ReproducedFigures& figures, const std::string& setting, const std::string& command);

/// The table for people. Runs that deviate from the paper's set-up are marked beside the verdict.
std::string reproduction_text(const std::vector<ReproducedRow>& rows);

/// How the runs of each study ended, the verdicts in a table, a line per row, and the bottom line.
std::string reproduction_table(const std::vector<ReproducedRow>& rows, const study::Evidence& evidence);

/// The table as JSON text: {setting, as_published, rows: [{id, sentence, published, ours, statistic, verdict, caveat,
/// kind, brief, why_not, verdict_in_larger_disc, verdict_second_edition}]}.
/// @param as_published  whether replicates and parameters are the paper's; otherwise these are no verdicts on it
std::string reproduction_json(const std::vector<ReproducedRow>& rows, const std::string& setting, bool as_published);

} // namespace matrigrate::apps
