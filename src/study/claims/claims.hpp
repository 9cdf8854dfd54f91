#pragma once

#include "claims/judge.hpp"
#include "study_runs/study_folder.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

/// The claims of Heck et al. 2020, and of experiments beside it, that ensembles of runs can bear out, one entry a row
/// of the table to reproduce. They stand in the files of studies/. The conditions of a claim follow from its sentence,
/// were written before the runs that they judge, and are not changed after them.
///
/// How sentences are read: "rises" and "falls" compare the lowest with the highest value of the parameter,
/// significantly; "unaffected" and "no significant change" mean no significant difference there; "slightly" asks for
/// the sign only; a published mean agrees if it could be the mean of as many more runs of ours (published_mean_test);
/// "a low f_adh_rel" is one below readouts.hpp's low_relative_force; "near 1" is within 0.25. Speeds along the
/// path are sampled every 60 s, since the paper names no interval.
/// Test: tests/unit/claims/claims_test.cpp
namespace matrigrate::study {

/// The claims of all shipped studies, by their ids: rows A to E of the paper, and rows X, experiments beside it, which
/// are not among the paper's twenty-six.
std::vector<Claim> shipped_claims();

/// A claim with what became of it.
struct JudgedClaim {
  std::string id;
  ClaimKind kind = ClaimKind::predicted;
  std::string sentence;
  std::string published;
  Finding finding;
  std::optional<Finding> in_larger_disc{}; ///< with runs that ended at the rim made again in a larger disc
  std::optional<Finding> second_edition{}; ///< by the second edition of the rules, where the third changed them
  std::string caveat{};                    ///< "not the paper's runs" where the runs of its studies are not; else ""
  std::vector<std::string> studies{};      ///< names of those that it is judged by, as far as there are any
};

JudgedClaim judged_claim(const Claim& claim, const Evidence& evidence);

/// The claims of this study and, of a shipped one, those of other shipped studies that need it, judged by its results
/// and by those of the other studies they need, as far as these lie beside its folder.
std::vector<JudgedClaim> claims_about(const StudyFolder& study, const std::vector<Result>& results);

/// How this study differs from the shipped one, and what follows for the verdicts; "" if it does not differ.
std::string claims_note(const Study& study);

/// Why a claim does not hold, in a line; empty if it does.
std::string why_not(const Finding& finding);

/// "15 of 26 hold: 10 of 19 calibration, 5 of 7 predicted; 5 more in direction"
std::string bottom_line(const std::vector<JudgedClaim>& claims);

/// claims.csv: the table that people read, a line per claim.
std::string claims_csv(const std::vector<JudgedClaim>& claims);

/// For programs, of each claim {id, sentence, published, ours, statistic, verdict, caveat, kind, brief, why_not,
/// verdict_in_larger_disc, against}, and of a claim whose rules the third edition changed {verdict_second_edition,
/// why_not_second_edition, against_second_edition, statistic_second_edition}. The tables have the same, with these
/// columns where a claim of theirs has them.
nlohmann::ordered_json claims_json(const std::vector<JudgedClaim>& claims);

/// Every mean and condition of each claim.
std::string conditions_csv(const std::vector<JudgedClaim>& claims);

} // namespace matrigrate::study
