#pragma once

#include "report/verdict_page.hpp"
#include "study_plan/claim_rules.hpp"
#include "study_runs/study_folder.hpp"

#include <nlohmann/json_fwd.hpp>

#include <map>
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
///
/// Whether what a paper says comes out of studies: conditions on groups of runs, each with its statistic. The test is
/// the paper's, an unpaired two-sample t-test at 0.05.
/// - Where a claim says of several comparisons that they do not differ, or of several means that they agree with
///   published ones, p-values are corrected within the claim (Holm), since ten true nulls at 0.05 each fail two times
///   in five. A mean within a tenth of the published one agrees whatever the scatter.
/// - A claim whose stated directions and orders all come out, though a value or a significance is missed, is "in
///   direction".
/// - A test that finds nothing says nothing where it could not have: where a 95 % interval reaches further to either
///   side than half of what the condition is about (the larger of two means, the published mean, r = 1), a condition
///   that p >= 0.05 would meet is not told, and the claim undecided unless another condition fails.
/// Test: tests/unit/claims/claims_test.cpp
namespace matrigrate::study {

/// A study and the results of its runs.
struct Ensemble {
  Study study;
  std::vector<Result> results;
  MsdCurves msd{}; ///< of the results, in their order; empty where a run has none, or none is known
};

/// By the name of the study.
using Evidence = std::map<std::string, Ensemble, std::less<>>;

using report::Verdict;

/// The verdict on a claim.
struct Finding {
  Verdict verdict = Verdict::undecided;
  std::vector<std::string> ours;       ///< means with their 95 % intervals
  std::vector<std::string> conditions; ///< each with its statistic, and whether it is met: "A is above B (...): met"
  std::string brief{};                 ///< ours in a line, for a table
  std::vector<std::string> unmet{};    ///< why it does not hold: the conditions that are not met
  std::vector<std::string> against{};  ///< conditions whose direction comes out opposite by its whole interval
};

/// What becomes of a claim by the evidence, under an edition of the rules.
Finding judged(const Claim& claim, const Evidence& evidence, ClaimEdition edition = ClaimEdition::third);

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
