#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace matrigrate::statistics {

// What the tests need of distributions, from Boost.Math; NaN wherever an argument is outside of their domain.
// Test: tests/unit/statistics/statistics_test.cpp

inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

double normal_two_sided(double z);                ///< P(|Z| > |z|)
double normal_quantile(double probability);       ///< of the standard normal
double t_two_sided(double t, double df);          ///< P(|T| > |t|)
double t_quantile(double probability, double df); ///< of Student's t

/// The non-centrality for which P(T <= t) is the given probability: falls as the probability rises.
double t_noncentrality(double t, double df, double probability);

/// Chance that |T| with this non-centrality is beyond what alpha asks for.
double t_power(double noncentrality, double df, double alpha);

/// The non-centrality that has this power.
double t_detectable(double df, double alpha, double power);

} // namespace matrigrate::statistics

namespace matrigrate {

// Whether a sample follows a distribution. Test: tests/unit/base/base_test.cpp

/// Kolmogorov-Smirnov statistic D sqrt(n) of a sample against the distribution function `cdf`. Its critical value at
/// the 1 % level is 1.63.
template <class Distribution>
double kolmogorov_smirnov(std::vector<double> sample, const Distribution& cdf) {
  std::sort(sample.begin(), sample.end());
  const auto n = static_cast<double>(sample.size());
  double D = 0.0;
  for (std::size_t k = 0; k < sample.size(); ++k) {
    const double F = cdf(sample[k]);
    D = std::max({D, F - static_cast<double>(k) / n, static_cast<double>(k + 1) / n - F});
  }
  return D * std::sqrt(n);
}

/// The same against the exponential distribution of a rate.
inline double kolmogorov_smirnov_exponential(std::vector<double> sample, double rate) {
  return kolmogorov_smirnov(std::move(sample), [rate](double t) { return -std::expm1(-rate * t); });
}

inline constexpr double one_in_a_hundred = 1.63;

} // namespace matrigrate
