#pragma once

#include "study/results.hpp"
#include "study/study.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Whether what a paper says comes out of studies: conditions on groups of runs, each with its statistic. The test is
/// the paper's, an unpaired two-sample t-test at 0.05. Each claim is judged twice, by two editions of the rules:
/// - first: no correction, and every condition must be met, as the paper's text has it;
/// - second: where a claim says of several comparisons that they do not differ, or of several means that they agree
/// with
///   published ones, p-values are corrected within the claim (Holm), since ten true nulls at 0.05 each fail two times
///   in five; a mean within a tenth of the published one agrees whatever the scatter; and a claim whose stated
///   directions and orders all come out, though a value or a significance is missed, is "in direction".
/// Test: tests/unit/claims/claims_test.cpp
namespace matrigrate::study {

/// A study and the results of its runs.
struct Ensemble {
  Study study;
  std::vector<Result> results;
};

/// By the name of the study.
using Evidence = std::map<std::string, Ensemble, std::less<>>;

/// The runs at one point of a study.
struct Group {
  std::string_view study;
  std::size_t point;
};

enum class Verdict { holds, in_direction, does_not_hold, undecided };

/// The verdict on a claim.
struct Finding {
  Verdict verdict = Verdict::undecided;    ///< by the first edition, which knows no "in direction"
  std::vector<std::string> ours;           ///< means with their 95 % intervals
  std::vector<std::string> conditions;     ///< each with its statistic, and whether it is met
  std::string brief{};                     ///< ours in a line, for a table
  std::vector<std::string> unmet{};        ///< why it does not hold: the conditions that are not met, shortened
  Verdict second = Verdict::undecided;     ///< by the second edition
  std::vector<std::string> second_unmet{}; ///< the same by the second edition
};

enum class Sign { up, down };

/// Gathers conditions; a claim holds if all of them are met, and is undecided where a group has fewer than two runs.
class Judge {
public:
  explicit Judge(const Evidence& evidence) : m_evidence(evidence) {}

  /// b is significantly above (or below) a.
  Judge& differs(Group a, Group b, std::string_view readout, Sign sign);
  /// b does not differ significantly from a.
  Judge& same(Group a, Group b, std::string_view readout);
  /// The mean of b is above (or below) that of a, significantly or not: "slightly".
  Judge& leans(Group a, Group b, std::string_view readout, Sign sign);
  /// b is not significantly above (or below) a.
  Judge& not_beyond(Group a, Group b, std::string_view readout, Sign sign);
  /// In the runs of a group the second read-out is above the first: the 95 % interval of their difference is above 0.
  Judge& exceeds(Group g, std::string_view low, std::string_view high);
  /// The published mean of n runs could be one of our population: published_mean_test with p >= 0.05.
  Judge& agrees(Group g, std::string_view readout, double published, double n_published);
  /// The lowest (or highest) mean of the first `points` points agrees with a published one.
  Judge& extreme_agrees(std::string_view study, std::size_t points, std::string_view readout, Sign which,
                        double published, double n_published);
  /// The mean lies between two bounds.
  Judge& within(Group g, std::string_view readout, double low, double high);
  /// The 95 % interval of the mean lies below a bound.
  Judge& below(Group g, std::string_view readout, double bound);
  /// The 95 % interval of the mean lies above a bound.
  Judge& above(Group g, std::string_view readout, double bound);
  /// The means of b and a are in a ratio below a bound.
  Judge& ratio_below(Group a, Group b, std::string_view readout, double bound);
  /// Pearson's r over all runs of a study is significant and has this sign; or is not significant.
  Judge& correlates(std::string_view study, std::string_view x, std::string_view y, Sign sign);
  Judge& uncorrelated(std::string_view study, std::string_view x, std::string_view y);
  /// Over all runs of a study: the mean is above a bound; no run is above a bound.
  Judge& mean_above(std::string_view study, std::string_view readout, double bound);
  Judge& none_above(std::string_view study, std::string_view readout, double bound);
  /// At least a share of the runs of a study is not above a bound.
  Judge& mostly_up_to(std::string_view study, std::string_view readout, double bound, double share);

  /// The conditions from here on belong to one edition alone, or to both.
  Judge& only_first() { return for_editions(true, false); }
  Judge& only_second() { return for_editions(false, true); }
  Judge& for_both() { return for_editions(true, true); }

  Finding finding() const;

private:
  std::vector<double> values(Group g, std::string_view readout);
  std::vector<double> column(std::string_view study, std::string_view readout);
  std::string label(Group g) const;
  void tell(Group g, std::string_view readout, const std::vector<double>& x);
  /// Conditions of a claim whose p-values the second edition corrects together.
  enum class Family { none, no_difference, agreement };
  /// How the second edition takes a condition.
  struct Reading {
    std::optional<bool> direction{}; ///< whether the stated direction comes out; none where the claim states none
    Family family = Family::none;
    double p = 1.0;     ///< of the condition's family
    bool close = false; ///< agrees whatever its p-value
  };
  struct Condition {
    std::string text; ///< shortened
    bool defined, met;
    Reading reading;
  };
  Judge& for_editions(bool first, bool second) {
    m_first = first;
    m_second = second;
    return *this;
  }
  void condition(const std::string& wanted, const std::string& measured, bool defined, bool met, Reading reading);
  std::string shortened(std::string text) const;
  std::string brief() const;
  void compare(Group a, Group b, std::string_view readout, std::string_view wanted,
               const std::function<bool(double difference, double p)>& met,
               const std::function<Reading(double difference, double p)>& reading);
  void correlate(std::string_view study, std::string_view x, std::string_view y, std::string_view wanted,
                 const std::function<bool(double r, double p)>& met, const std::function<Reading(double r)>& reading);
  void judge_again(Finding& finding) const;

  /// A mean that a condition is about.
  struct Mean {
    Group group;
    std::string readout;
    std::string label;
    std::string value; ///< with its interval
  };

  const Evidence& m_evidence;
  std::vector<Mean> m_means;
  std::vector<std::string> m_others; ///< correlations, and numbers over all runs of a study
  bool m_defined = true;
  bool m_met = true;
  std::vector<std::string> m_ours;
  std::vector<std::string> m_conditions;
  std::vector<std::string> m_unmet;
  bool m_first = true, m_second = true;
  std::vector<Condition> m_again; ///< conditions of the second edition
};

std::string to_string(Verdict verdict);

} // namespace matrigrate::study
