#pragma once

#include "claims/claims.hpp"
#include "study_runs/study_folder.hpp"

#include <string>
#include <vector>

/// What a study says of its claims, and of those of the paper. Test: tests/apps/study_test.cpp
namespace matrigrate::study {

/// The claims of this study and, of a shipped one, those of other shipped studies that need it, judged by its results
/// and by those of the other studies they need, as far as these lie beside its folder.
std::vector<JudgedClaim> claims_about(const StudyFolder& study, const std::vector<Result>& results);

/// How this study differs from the shipped one, and what follows for the verdicts; "" if it does not differ.
std::string claims_note(const study::Study& study);

/// "not the paper's runs" if replicates or parameters other than those of the integrator are not the paper's; else "".
std::string claims_caveat(const study::Study& study);

} // namespace matrigrate::study
