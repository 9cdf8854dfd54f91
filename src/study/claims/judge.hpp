#pragma once

#include "report/verdict_page.hpp"
#include "study_plan/claim_rules.hpp"
#include "study_plan/study.hpp"
#include "study_results/results.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

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

} // namespace matrigrate::study
