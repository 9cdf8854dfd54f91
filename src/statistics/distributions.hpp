#pragma once

#include <limits>

/// What the tests need of distributions, from Boost.Math; NaN wherever an argument is outside of their domain.
/// Test: tests/unit/statistics/statistics_test.cpp
namespace matrigrate::statistics {

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
