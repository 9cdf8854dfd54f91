#pragma once

#include "claims/evidence.hpp"

#include <string>
#include <string_view>
#include <vector>

/// The files that `matrigrate reproduce` writes of its verdicts. Test: tests/apps/reproduce_test.cpp,
/// viewer/tests/verdict_page.test.ts
namespace matrigrate::study {

/// What the page says of how it was made.
struct ClaimReport {
  std::string_view page_template;
  std::string setting; ///< how the runs were made
  std::string command;
};

/// @throws InputOutputError naming the files that write_claim_report() would replace and that are not of this program
void require_own_claim_report(const EvidenceOptions& options);

/// Writes claims-<ID>.csv, claims.csv, report-<ID>.html and the tables of its figures into the folder of the options.
/// @throws InputOutputError if a table cannot be read
void write_claim_report(const std::vector<JudgedClaim>& rows, const Evidence& evidence, const EvidenceOptions& options,
                        const ClaimReport& report);

/// "with runs that ended at the rim made again in a larger disc: holds; ..."
std::string with_larger_disc(const Finding& finding);

} // namespace matrigrate::study
