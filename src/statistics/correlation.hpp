#pragma once

#include "statistics/sample.hpp"

#include <cstddef>
#include <vector>

/// How two quantities go together. Test: tests/unit/statistics/statistics_test.cpp
namespace matrigrate::statistics {

/// Pearson's r of those pairs in which both values are finite.
struct Correlation {
  std::size_t n;
  double r; ///< NaN for n < 2 or where either quantity has no spread
  double p; ///< two-sided, of t = r sqrt((n - 2) / (1 - r^2)) with n - 2 degrees of freedom; NaN for n < 3
};

/// @param x, y  of one length
/// @throws std::invalid_argument if they are not
Correlation pearson(Values x, Values y);

/// Interval of r by Fisher's transformation, with r as its value; NaN for n < 4 and |r| = 1.
Interval correlation_interval(const Correlation& found, double alpha);

/// Spearman's rank correlation: Pearson's r of the ranks, of equal values the mean of theirs. p is by the same t, which
/// is good from about ten pairs on.
/// @throws std::invalid_argument if x and y are not of one length
Correlation spearman(Values x, Values y);

/// Pearson's r within groups: of the deviations from the mean of the group, so that what differs between groups makes
/// no correlation. p has n - k - 1 degrees of freedom, for k groups with two pairs or more; others are left out.
/// @param x, y, group  of one length
/// @throws std::invalid_argument if they are not
Correlation pearson_within(Values x, Values y, const std::vector<std::size_t>& group);

} // namespace matrigrate::statistics
