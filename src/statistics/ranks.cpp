#include "statistics/compare.hpp"
#include "statistics/distributions.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate::statistics {

namespace {

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
