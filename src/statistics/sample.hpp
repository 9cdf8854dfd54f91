#pragma once

#include <cstddef>
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

} // namespace matrigrate::statistics
