#pragma once

#include "statistics/compare.hpp"
#include "study_plan/study.hpp"
#include "study_results/results.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// How far the read-outs of a study are from their targets. Test: tests/unit/study_results/discrepancy_test.cpp
namespace matrigrate::study {

/// A target at one of its conditions.
struct Term {
  std::size_t target = 0;
  std::size_t condition = 0;

  bool operator==(const Term&) const = default;
};

/// All targets at all their conditions, in the order of the study.
std::vector<Term> terms(const Study& study);

/// "v_migr_abs_um_per_h_at_soft"; without conditions the read-out alone.
std::string term_name(const Study& study, const Term& term);

/// "12.1 +- 1", "3 to 5 +- 0.2".
std::string target_text(const Target& target);

/// A factor set by a term.
///   z = (mean - target) / sqrt(error^2 + s^2 / n),  0 within a range, from its nearer end outside
struct Judged {
  std::size_t n = 0;         ///< runs that are done and have a value
  std::size_t undefined = 0; ///< runs that are done and have none
  double mean = 0.0;         ///< NaN for n = 0
  double z = 0.0;            ///< NaN for n < 2: the target is not judged
};

/// z of a mean with its standard error, and of a sample; NaN for fewer than two values.
double distance(const Target& target, double mean, double standard_error);
double distance(const Target& target, statistics::Values sample);

/// D of one run by targets, from the z of each; NaN if one of them is.
double distance_of_run(const std::vector<Target>& targets, const std::vector<double>& z);

/// A factor set by all terms that could be judged.
///   D = sqrt(sum w z^2 / sum w)
struct Discrepancy {
  std::size_t set = 0;
  statistics::Interval value; ///< NaN if no target was judged; the interval by the bootstrap over replicates
  std::size_t judged = 0;     ///< terms with a z
  std::vector<Judged> terms;  ///< in the order of terms()
};

/// Judges factor sets from the results of a study. With common random numbers a draw of the bootstrap takes the same
/// replicates at all points, so that differences of sets stay paired; otherwise each point is drawn for itself. Means
/// are drawn; standard errors stay those of the samples, since a draw from few replicates may hold one of them alone.
class TargetJudge {
public:
  /// @param study, results  must outlive it
  TargetJudge(const Study& study, const std::vector<Result>& results);

  /// With its interval by bootstrap_draws draws.
  Discrepancy discrepancy(std::size_t set) const;

  /// The discrepancy in each draw; NaN where a term that was judged has no value left.
  std::vector<double> draws(std::size_t set) const;

private:
  /// The value of each replicate at a point, from the first on; NaN where a replicate has none.
  /// @param readout  column of all_readouts()
  std::vector<double> replicates(std::size_t point, std::size_t readout) const;
  double combined(const std::vector<double>& z) const;

  const Study& m_study;
  std::vector<Term> m_terms;
  std::vector<std::size_t> m_columns;                ///< of the read-out of each term
  std::vector<std::vector<const Result*>> m_results; ///< by point and replicate, null where there is none
};

/// Those of all factor sets, in the order of the study; none without targets.
std::vector<Discrepancy> discrepancies(const Study& study, const std::vector<Result>& results);

/// Indices of discrepancies from the best on: by the number of judged terms, then by value.
std::vector<std::size_t> ranking(const std::vector<Discrepancy>& all);

/// discrepancy.csv: a row per factor set, in the order of ranking().
std::string discrepancy_csv(const Study& study, const std::vector<Discrepancy>& all);

} // namespace matrigrate::study
