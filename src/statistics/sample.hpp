#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Samples and what describes them. What is not defined is NaN, never an error: a mean of nothing, a standard deviation
/// of one value. Values that are not finite are for the caller to leave out (see finite()).
/// Test: tests/unit/statistics/statistics_test.cpp
namespace matrigrate::statistics {

using Values = std::span<const double>;

/// Those values that are finite, in their order.
std::vector<double> finite(Values x);

/// Size, mean and standard deviation of a sample.
struct Moments {
  std::size_t n = 0;
  double mean = 0.0; ///< NaN for n = 0
  double sd = 0.0;   ///< sqrt(sum (x - mean)^2 / (n - 1)); NaN for n < 2
};
Moments moments(Values x);

/// An estimate with its confidence interval.
struct Interval {
  double value;
  double low;
  double high;
};

/// Mean of the values that are not NaN; NaN if there are none.
double mean_of_defined(Values x);

/// Quantile of a sample by linear interpolation between order statistics, at (n - 1) share of the way: definition 7 of
/// Hyndman and Fan 1996, Am Stat 50: 361, the default of R and NumPy. NaN for an empty sample.
/// @param share  in [0, 1]
double quantile(Values x, double share);

/// A box with whiskers after Tukey: the whiskers end at the outermost values within 1.5 times the height of the box,
/// or at the box where these lie within it.
struct Box {
  double low_whisker, low_quartile, median, high_quartile, high_whisker; ///< all NaN for an empty sample
  std::vector<double> outliers;                                          ///< beyond the whiskers, ascending
};
Box box(Values x);

// The bootstrap (Efron 1979, Ann Stat 7: 1): how much an estimate varies if the sample is drawn again from itself.
// Draws are counter-based, so that intervals are the same each time.

/// Draws that an interval is made of.
inline constexpr std::size_t bootstrap_draws = 1000;

/// Which of n values a draw takes, with replacement: n indices below n.
/// @param key   of the sample; two samples with one key are drawn alike, and stay paired
/// @param draw  number of the draw
std::vector<std::size_t> resampled(std::size_t n, std::uint64_t key, std::size_t draw);

/// The values of a draw.
std::vector<double> picked(Values x, const std::vector<std::size_t>& indices);

/// An estimate with the interval between the quantiles alpha/2 and 1 - alpha/2 of its draws. Draws in which it is not
/// defined are left out; the interval is not defined if they are more than half.
/// @param alpha  1 minus the confidence, in (0, 1)
Interval percentile_interval(double value, Values draws, double alpha);

} // namespace matrigrate::statistics
