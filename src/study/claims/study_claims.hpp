#pragma once

#include "claims/claims.hpp"
#include "study_runs/study_folder.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Which of the paper's claims a study speaks of. Test: tests/apps/study_test.cpp
namespace matrigrate::study {

/// The name of the shipped study of this title and with these points: "stiffness".
std::optional<std::string_view> shipped_name(const study::Study& study);

/// The claims that need this study, judged by its results and by those of the other studies they need, as far as these
/// lie beside its folder; none if it is no shipped study.
std::vector<study::JudgedClaim> claims_about(const StudyFolder& study, const std::vector<study::Result>& results);

/// How this study differs from the shipped one, and what follows for the verdicts; "" if it does not differ.
std::string claims_note(const study::Study& study);

/// "not the paper's runs" if replicates or parameters other than those of the integrator are not the paper's; else "".
std::string claims_caveat(const study::Study& study);

/// claims_caveat() of the studies that a claim needs, as far as they are among the evidence, and for F1 of the study
/// whose frames decide; "" for other ids.
std::string claims_caveat(const std::string& id, const study::Evidence& evidence);

} // namespace matrigrate::study
