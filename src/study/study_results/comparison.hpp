#pragma once

#include "statistics/compare.hpp"
#include "statistics/correlation.hpp"
#include "study_plan/study.hpp"
#include "study_results/results.hpp"

#include <string>
#include <utility>
#include <vector>

/// Differences between the points of a study. Test: tests/unit/study_results/comparison_test.cpp
namespace matrigrate::study {

/// Points that are compared, as indices, first the one that is subtracted. Adjacent ones differ in one parameter only,
/// and there in neighbouring values, in the order in which the study names them.
std::vector<std::pair<std::size_t, std::size_t>> compared_pairs(const Study& study);

/// Two points in one read-out, b against a.
struct Comparison {
  std::string readout;
  std::size_t a = 0;
  std::size_t b = 0;
  statistics::Moments sample_a, sample_b;
  statistics::Interval difference; ///< of the means, b minus a, in the unit of the read-out
  statistics::TestResult test;     ///< the one that the study names
  double p_holm = 0.0;             ///< corrected over all pairs of this read-out
  statistics::Interval g{};        ///< effect size of Hedges, with its interval
  double detectable = 0.0;         ///< smallest difference that t_test finds with a power of 80 %, in the unit
};

inline constexpr double wanted_power = 0.8;

/// All pairs in all read-outs of the study.
std::vector<Comparison> comparisons(const Study& study, const std::vector<Result>& results);

/// A read-out at a point, over the runs that are done.
struct ReadOutSample {
  std::string readout;
  std::size_t point = 0;
  statistics::Moments moments;
  statistics::Interval mean; ///< with its interval
  statistics::Box box;
};

/// All points in all read-outs of the study.
std::vector<ReadOutSample> samples(const Study& study, const std::vector<Result>& results);

/// Runs that a test needs at each of its points before a page or a table calls a difference significant: the scatter of
/// two runs says next to nothing.
inline constexpr std::size_t least_runs = 3;

/// statistics.csv: a row for each comparison, with the swept parameters of both points. Means, standard deviations,
/// differences and their bounds are in the unit that ends the name of the read-out. Like groups.csv it counts the runs
/// that ended at the rim.
std::string statistics_csv(const Study& study, const std::vector<Comparison>& comparisons,
                           const std::vector<Result>& results);

/// groups.csv: a row for each point and read-out: swept parameters, size, mean with interval, standard deviation,
/// quartiles, whiskers.
std::string groups_csv(const Study& study, const std::vector<Result>& results);

/// Pearson's r within points of each pair of read-outs, so that what differs between points makes no correlation.
struct Correlations {
  std::vector<std::string> readouts;                       ///< those with scatter within a point
  std::vector<std::vector<statistics::Correlation>> pairs; ///< of each read-out with each
  std::vector<std::vector<double>> p_holm;                 ///< after Holm over all pairs; NaN of one with itself
};
Correlations correlations(const Study& study, const std::vector<Result>& results);

/// correlations.csv: these, a row for each pair.
std::string correlations_csv(const Correlations& found);

std::string name(TestKind test);

} // namespace matrigrate::study
