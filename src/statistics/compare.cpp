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

constexpr std::size_t largest_exact = 50;

/// Values to twelve digits: means of the same numbers in another order differ in the last bit, and are equal.
std::vector<double> rounded(Values x) {
  std::vector<double> all(x.begin(), x.end());
  for (double& value : all) {
    if (value == 0.0 || !std::isfinite(value)) continue;
    const double digits = 11.0 - std::floor(std::log10(std::abs(value)));
    if (digits > 300.0 || digits < -290.0) continue; // the power of ten would be no normal number
    const double scale = std::pow(10.0, std::abs(digits));
    value = digits >= 0.0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
  }
  return all;
}

/// How many of the arrangements of n and m values have each U: the coefficients of the Gaussian binomial
/// prod_{i=1..n} (1 - q^(m + i)) / (1 - q^i).
std::vector<double> arrangements(std::size_t n, std::size_t m) {
  std::vector<double> count(n * m + 1, 0.0);
  count[0] = 1.0;
  for (std::size_t i = 1; i <= n; ++i) {
    for (std::size_t u = count.size(); u-- > m + i;) count[u] -= count[u - m - i];
    for (std::size_t u = i; u < count.size(); ++u) count[u] += count[u - i];
  }
  return count;
}

/// P(|U - n m/2| >= |u - n m/2|), the distribution being symmetric.
double exact_two_sided(double u, std::size_t n, std::size_t m) {
  const std::vector<double> count = arrangements(n, m);
  const double low = std::min(u, static_cast<double>(n * m) - u);
  double all = 0.0;
  double tail = 0.0;
  for (std::size_t i = 0; i < count.size(); ++i) {
    all += count[i];
    if (static_cast<double>(i) <= low) tail += count[i];
  }
  return std::min(1.0, 2.0 * tail / all);
}

/// sum of (t^3 - t) over the groups of t equal values of both samples
double tie_sum(Values a, Values b) {
  std::vector<double> all(a.begin(), a.end());
  all.insert(all.end(), b.begin(), b.end());
  std::ranges::sort(all);
  double sum = 0.0;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i;
    while (end < all.size() && all[end] == all[i]) ++end;
    const auto t = static_cast<double>(end - i);
    sum += t * t * t - t;
    i = end;
  }
  return sum;
}

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

TestResult mann_whitney_test(Values x, Values y) {
  if (x.empty() || y.empty()) return {undefined, undefined, undefined};
  const std::vector<double> a = rounded(x);
  const std::vector<double> b = rounded(y);
  double u = 0.0;
  for (const double low : a)
    for (const double high : b) u += high > low ? 1.0 : high == low ? 0.5 : 0.0;
  const double ties = tie_sum(a, b);
  if (ties == 0.0 && a.size() < largest_exact && b.size() < largest_exact)
    return {u, undefined, exact_two_sided(u, a.size(), b.size())};
  const auto n = static_cast<double>(a.size());
  const auto m = static_cast<double>(b.size());
  const double variance = n * m / 12.0 * (n + m + 1.0 - ties / ((n + m) * (n + m - 1.0)));
  if (!(variance > 0.0)) return {u, undefined, undefined};
  const double off = std::max(0.0, std::abs(u - 0.5 * n * m) - 0.5);
  return {u, undefined, normal_two_sided(off / std::sqrt(variance))};
}

} // namespace matrigrate::statistics
