#include "statistics/sample.hpp"

#include "base/random.hpp"
#include "statistics/distributions.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate::statistics {

namespace {

double quantile_of_sorted(Values x, double share) {
  if (x.empty()) return undefined;
  const double place = share * static_cast<double>(x.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, x.size() - 1);
  return x[below] + (place - static_cast<double>(below)) * (x[above] - x[below]);
}

std::vector<double> sorted(Values x) {
  std::vector<double> y(x.begin(), x.end());
  std::ranges::sort(y);
  return y;
}

} // namespace

std::vector<double> finite(Values x) {
  std::vector<double> y(x.begin(), x.end());
  std::erase_if(y, [](double value) { return !std::isfinite(value); });
  return y;
}

Moments moments(Values x) {
  Moments m{x.size(), undefined, undefined};
  if (x.empty()) return m;
  const auto n = static_cast<double>(x.size());
  double sum = 0.0;
  for (const double value : x) sum += value;
  m.mean = sum / n;
  if (x.size() < 2) return m;
  double squares = 0.0;
  for (const double value : x) squares += (value - m.mean) * (value - m.mean);
  m.sd = std::sqrt(squares / (n - 1.0));
  return m;
}

double mean_of_defined(Values x) {
  std::vector<double> defined(x.begin(), x.end());
  std::erase_if(defined, [](double value) { return std::isnan(value); });
  return moments(defined).mean;
}

double quantile(Values x, double share) { return quantile_of_sorted(sorted(x), share); }

Box box(Values x) {
  const std::vector<double> y = sorted(x);
  Box b{undefined, quantile_of_sorted(y, 0.25), quantile_of_sorted(y, 0.5), quantile_of_sorted(y, 0.75), undefined, {}};
  const double reach = 1.5 * (b.high_quartile - b.low_quartile);
  for (const double value : y) {
    if (value < b.low_quartile - reach || value > b.high_quartile + reach) {
      b.outliers.push_back(value);
      continue;
    }
    if (std::isnan(b.low_whisker)) b.low_whisker = value;
    b.high_whisker = value;
  }
  if (!y.empty()) { // quartiles lie between values, so the innermost value may lie within the box
    b.low_whisker = std::min(b.low_whisker, b.low_quartile);
    b.high_whisker = std::max(b.high_whisker, b.high_quartile);
  }
  return b;
}

std::vector<std::size_t> resampled(std::size_t n, std::uint64_t key, std::size_t draw) {
  std::vector<std::size_t> indices(n);
  for (std::size_t i = 0; i < n; ++i)
    indices[i] = static_cast<std::size_t>(uniform(key, Purpose::sampling, draw, static_cast<std::uint32_t>(i))
                                          * static_cast<double>(n));
  return indices;
}

std::vector<double> picked(Values x, const std::vector<std::size_t>& indices) {
  std::vector<double> values;
  values.reserve(indices.size());
  for (const std::size_t i : indices) values.push_back(x[i]);
  return values;
}

Interval percentile_interval(double value, Values draws, double alpha) {
  const std::vector<double> defined = finite(draws);
  if (std::isnan(value) || defined.empty() || 2 * defined.size() < draws.size()) return {value, undefined, undefined};
  return {value, quantile(defined, 0.5 * alpha), quantile(defined, 1.0 - 0.5 * alpha)};
}

} // namespace matrigrate::statistics
