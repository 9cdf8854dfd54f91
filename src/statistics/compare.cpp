#include "statistics/compare.hpp"

#include "statistics/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace matrigrate::statistics {

namespace {

/// What t, its degrees of freedom and the standard error of a difference are.
struct Student {
  double difference, error, df;
  TestResult test() const {
    if (!(error > 0.0)) return {undefined, df, undefined};
    const double t = difference / error;
    return {t, df, t_two_sided(t, df)};
  }
};

Student student(Values a, Values b, bool pooled) {
  const Moments p = moments(a);
  const Moments q = moments(b);
  if (p.n < 2 || q.n < 2) return {q.mean - p.mean, undefined, undefined};
  const auto n = static_cast<double>(p.n);
  const auto m = static_cast<double>(q.n);
  if (pooled) return {q.mean - p.mean, pooled_sd(p, q) * std::sqrt(1.0 / n + 1.0 / m), n + m - 2.0};
  const double u = p.sd * p.sd / n;
  const double v = q.sd * q.sd / m;
  const double df = (u + v) * (u + v) / (u * u / (n - 1.0) + v * v / (m - 1.0));
  return {q.mean - p.mean, std::sqrt(u + v), df};
}

/// The bias of the effect size, J(m).
double bias(double m) { return std::exp(std::lgamma(0.5 * m) - std::lgamma(0.5 * (m - 1.0))) / std::sqrt(0.5 * m); }

} // namespace

double pooled_sd(const Moments& a, const Moments& b) {
  const auto squares = [](const Moments& m) { return m.n < 2 ? 0.0 : static_cast<double>(m.n - 1) * m.sd * m.sd; };
  if (a.n < 1 || b.n < 1 || a.n + b.n < 3) return undefined;
  return std::sqrt((squares(a) + squares(b)) / static_cast<double>(a.n + b.n - 2));
}

TestResult t_test(Values a, Values b) { return student(a, b, true).test(); }

TestResult welch_test(Values a, Values b) { return student(a, b, false).test(); }

Interval mean_difference(Values a, Values b, double alpha, bool pooled) {
  const Student s = student(a, b, pooled);
  const double reach = t_quantile(1.0 - 0.5 * alpha, s.df) * s.error;
  return {s.difference, s.difference - reach, s.difference + reach};
}

Interval mean_interval(Values x, double alpha) {
  const Moments m = moments(x);
  const auto n = static_cast<double>(m.n);
  const double reach = m.n < 2 ? undefined : t_quantile(1.0 - 0.5 * alpha, n - 1.0) * m.sd / std::sqrt(n);
  return {m.mean, m.mean - reach, m.mean + reach};
}

Interval hedges_g(Values a, Values b, double alpha) {
  const TestResult test = t_test(a, b);
  if (std::isnan(test.statistic)) return {undefined, undefined, undefined};
  const double per_t = std::sqrt(1.0 / static_cast<double>(a.size()) + 1.0 / static_cast<double>(b.size()));
  const double scale = bias(test.df) * per_t;
  return {scale * test.statistic, scale * t_noncentrality(test.statistic, test.df, 1.0 - 0.5 * alpha),
          scale * t_noncentrality(test.statistic, test.df, 0.5 * alpha)};
}

double power(double n_a, double n_b, double difference, double alpha) {
  const double df = n_a + n_b - 2.0;
  if (!(n_a >= 1.0 && n_b >= 1.0 && df > 0.0)) return undefined;
  return t_power(difference / std::sqrt(1.0 / n_a + 1.0 / n_b), df, alpha);
}

double detectable_difference(double n_a, double n_b, double alpha, double wanted_power) {
  const double df = n_a + n_b - 2.0;
  if (!(n_a >= 1.0 && n_b >= 1.0 && df >= 2.0)) return undefined;
  return t_detectable(df, alpha, wanted_power) * std::sqrt(1.0 / n_a + 1.0 / n_b);
}

std::vector<double> holm(Values p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return std::isnan(p[i]); });
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p[i]; });
  std::vector<double> adjusted(p.size(), undefined);
  double least = 0.0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    least = std::max(least, std::min(1.0, static_cast<double>(order.size() - k) * p[order[k]]));
    adjusted[order[k]] = least;
  }
  return adjusted;
}

TestResult published_mean_test(Values x, double published, double n_published) {
  const Moments m = moments(x);
  if (m.n < 2) return {undefined, undefined, undefined};
  const auto n = static_cast<double>(m.n);
  return Student{published - m.mean, m.sd * std::sqrt(1.0 / n + 1.0 / n_published), n - 1.0}.test();
}

} // namespace matrigrate::statistics
