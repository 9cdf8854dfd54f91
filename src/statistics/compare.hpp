#pragma once

#include "statistics/sample.hpp"

#include <vector>

/// Whether two independent samples differ. Distributions come from Boost.Math. A test that is not defined (a sample of
/// fewer than two values, no spread in either) has NaN for all that cannot be told.
/// Test: tests/unit/statistics/statistics_test.cpp
namespace matrigrate::statistics {

/// Outcome of a two-sided test.
struct TestResult {
  double statistic; ///< t, or U of the first sample
  double df;        ///< degrees of freedom of t; NaN for ranks
  double p;
};

/// Standard deviation common to two samples, s of t_test; NaN with fewer than three values in all.
double pooled_sd(const Moments& a, const Moments& b);

/// Unpaired two-sample t-test with pooled variance (Student 1908), the one of Heck et al. 2020:
///   t = (mean_b - mean_a) / (s sqrt(1/n_a + 1/n_b)),  s^2 = ((n_a - 1) s_a^2 + (n_b - 1) s_b^2) / (n_a + n_b - 2)
TestResult t_test(Values a, Values b);

/// Welch 1947: no equal variances assumed; degrees of freedom after Satterthwaite.
///   t = (mean_b - mean_a) / sqrt(s_a^2/n_a + s_b^2/n_b)
TestResult welch_test(Values a, Values b);

/// Rank test of Mann and Whitney 1947. The statistic is U of b: pairs in which b is larger, ties counted half. The
/// distribution is exact for fewer than 50 values each without ties; else normal, with corrections for ties and for
/// continuity, as in R's wilcox.test.
TestResult mann_whitney_test(Values a, Values b);

/// Difference of means, b minus a, with the interval that belongs to t_test (`pooled`) or to welch_test.
/// @param alpha  1 minus the confidence, in (0, 1)
Interval mean_difference(Values a, Values b, double alpha, bool pooled = true);

/// Mean of a sample with its interval, mean +- t s / sqrt(n).
Interval mean_interval(Values x, double alpha);

/// Effect size of Hedges 1981, J Educ Stat 6: 107: the difference of means, b minus a, over the pooled standard
/// deviation, corrected for bias:
///   g = J(m) (mean_b - mean_a) / s,  J(m) = Gamma(m/2) / (sqrt(m/2) Gamma((m - 1)/2)),  m = n_a + n_b - 2
/// The interval is exact for normal samples: the non-central t distributions in whose tails the t found lies (Steiger
/// and Fouladi 1997), times J. It leaves out 0 where t_test gives p < alpha.
Interval hedges_g(Values a, Values b, double alpha);

/// Power of the two-sided t_test with pooled variance, from the non-central t distribution.
/// @param difference  of the means over the standard deviation
double power(double n_a, double n_b, double difference, double alpha);

/// The smallest difference of means, over the standard deviation, that t_test finds with this power. NaN where
/// n_a + n_b < 4 or either is below 1.
double detectable_difference(double n_a, double n_b, double alpha, double wanted_power);

/// Adjusted p-values of Holm 1979, Scand J Stat 6: 65, in the order given: reject those below alpha, and the chance of
/// any false rejection in the family stays below alpha. NaN stays NaN and does not count as a member of the family.
std::vector<double> holm(Values p);

/// Whether a mean published without its spread could be that of n_published more values of the same population: the
/// two-sided p-value of t = (published - mean) / (s sqrt(1/n + 1/n_published)), with n - 1 degrees of freedom.
TestResult published_mean_test(Values x, double published, double n_published);

} // namespace matrigrate::statistics
