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

/// Gathers conditions; a claim holds if all of them are met, and is undecided where a group has fewer than two runs or
/// the runs that there are tell too little. Its sentences name points by the values that vary.
class Judge {
public:
  /// @param study  that conditions mean where they name none
  Judge(const Evidence& evidence, std::string_view study) : m_evidence(evidence), m_study(study) {}

  Judge& add(const ClaimCondition& c);

  Finding finding() const;

private:
  /// The runs at one point of a study.
  struct Group {
    std::string study;
    std::string label;
    const Ensemble* ensemble = nullptr; ///< null where there is no such study, or no such point of it
    std::size_t point = 0;
  };
  struct Condition {
    std::string wanted;
    std::string measured;
    ClaimReading reading;
  };
  /// A mean that a condition is about.
  struct Mean {
    Group group;
    std::string what;
    std::string value; ///< with its interval
  };

  const Ensemble* ensemble(const std::string& study) const;
  Group group(const PointName& name) const;
  std::vector<double> values(const Group& g, std::string_view readout);
  std::vector<double> column(const ClaimCondition& c, std::string_view readout) const;
  MsdCurves curves(const Group& g);
  void tell(const Group& g, const std::string& what, const statistics::Interval& mean, std::size_t n);
  Group extreme(const ClaimCondition& c);
  std::vector<double> excess(const Group& g, const ClaimCondition& c);
  std::string filled(std::string_view sentence, const ClaimCondition& c, const Group& from, const Group& to) const;
  std::string brief() const;
  std::vector<Condition> corrected() const;

  /// "speed, start to end (um/h)"
  static std::string readout_words(std::string_view readout);

  const Evidence& m_evidence;
  std::string m_study;
  std::vector<Mean> m_means;
  std::vector<std::string> m_others; ///< correlations, and numbers over all runs of a study, in brief
  std::vector<std::string> m_ours;
  std::vector<Condition> m_conditions;
};

/// What becomes of a claim by the evidence, under an edition of the rules.
Finding judged(const Claim& claim, const Evidence& evidence, ClaimEdition edition = ClaimEdition::third);

} // namespace matrigrate::study
