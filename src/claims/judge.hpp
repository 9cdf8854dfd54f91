#pragma once

#include "study/results.hpp"
#include "study/study.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Whether what a paper says comes out of studies: conditions on groups of runs, each with its statistic. The test is
/// the paper's, an unpaired two-sample t-test at 0.05; no correction, as there. Test: tests/unit/claims/claims_test.cpp
namespace matrigrate::study {

/// A study with what its runs have come to.
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

enum class Verdict { holds, does_not_hold, undecided };

/// What became of a claim.
struct Finding {
  Verdict verdict = Verdict::undecided;
  std::vector<std::string> ours;       ///< means with their 95 % intervals
  std::vector<std::string> conditions; ///< each with its statistic, and whether it is met
  std::string brief{};                 ///< ours in a line, for a table
  std::vector<std::string> unmet{};    ///< why it does not hold: the conditions that are not met, shortened
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

  Finding finding() const;

private:
  std::vector<double> values(Group g, std::string_view readout);
  std::vector<double> column(std::string_view study, std::string_view readout);
  std::string label(Group g) const;
  void tell(Group g, std::string_view readout, const std::vector<double>& x);
  void condition(const std::string& wanted, const std::string& measured, bool defined, bool met);
  std::string shortened(std::string text) const;
  std::string brief() const;
  void compare(Group a, Group b, std::string_view readout, std::string_view wanted,
               const std::function<bool(double difference, double p)>& met);
  void correlate(std::string_view study, std::string_view x, std::string_view y, std::string_view wanted,
                 const std::function<bool(double r, double p)>& met);

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
};

std::string to_string(Verdict verdict);

} // namespace matrigrate::study
