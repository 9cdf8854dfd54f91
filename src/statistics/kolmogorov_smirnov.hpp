#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// Whether a sample follows a distribution. Test: tests/unit/base/base_test.cpp
namespace matrigrate {

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
