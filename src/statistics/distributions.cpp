#include "statistics/distributions.hpp"

#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/roots.hpp>

#include <cmath>

namespace matrigrate::statistics {

namespace {

namespace bm = boost::math;

/// No exceptions: what is not defined is NaN.
using Quiet = bm::policies::policy<bm::policies::domain_error<bm::policies::ignore_error>,
                                   bm::policies::pole_error<bm::policies::ignore_error>,
                                   bm::policies::overflow_error<bm::policies::ignore_error>,
                                   bm::policies::evaluation_error<bm::policies::ignore_error>>;
using StudentsT = bm::students_t_distribution<double, Quiet>;
using NoncentralT = bm::non_central_t_distribution<double, Quiet>;

bool good(double df) { return std::isfinite(df) && df > 0.0; }

double t_cdf(double t, double df, double noncentrality) { return bm::cdf(NoncentralT(df, noncentrality), t); }

constexpr double largest_noncentrality = 1e4; // beyond it the distribution is computed from squares that overflow

/// Where a function that falls from above 0 to below 0 crosses it, looked for from `start` outwards.
template <class Function>
double crossing(const Function& f, double start) {
  double reach = 1.0;
  while (reach < largest_noncentrality && !(f(start - reach) >= 0.0 && f(start + reach) <= 0.0)) reach *= 2.0;
  if (reach >= largest_noncentrality) return undefined;
  std::uintmax_t steps = 200;
  const auto near = [](double a, double b) { return std::abs(b - a) <= 1e-12 * (1.0 + std::abs(a)); };
  const auto [low, high] = bm::tools::bisect(f, start - reach, start + reach, near, steps);
  return 0.5 * (low + high);
}

} // namespace

double normal_two_sided(double z) {
  if (std::isnan(z)) return undefined;
  return 2.0 * bm::cdf(bm::complement(bm::normal_distribution<double, Quiet>(), std::abs(z)));
}

double normal_quantile(double probability) {
  return bm::quantile(bm::normal_distribution<double, Quiet>(), probability);
}

double t_two_sided(double t, double df) {
  if (std::isnan(t) || !good(df)) return undefined;
  return 2.0 * bm::cdf(bm::complement(StudentsT(df), std::abs(t)));
}

double t_quantile(double probability, double df) {
  return good(df) ? bm::quantile(StudentsT(df), probability) : undefined;
}

double t_noncentrality(double t, double df, double probability) {
  if (std::isnan(t) || std::abs(t) > largest_noncentrality || !good(df)) return undefined;
  return crossing([&](double delta) { return t_cdf(t, df, delta) - probability; }, t);
}

double t_power(double noncentrality, double df, double alpha) {
  const double limit = t_quantile(1.0 - 0.5 * alpha, df);
  if (std::isnan(limit) || !std::isfinite(noncentrality)) return undefined;
  return 1.0 - t_cdf(limit, df, noncentrality) + t_cdf(-limit, df, noncentrality);
}

double t_detectable(double df, double alpha, double power) {
  if (!good(df)) return undefined;
  const double limit = t_quantile(1.0 - 0.5 * alpha, df);
  const auto lack = [&](double delta) { return delta <= 0.0 ? power - alpha : power - t_power(delta, df, alpha); };
  return crossing(lack, limit);
}

} // namespace matrigrate::statistics
