#include "statistics/correlation.hpp"

#include "statistics/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

namespace matrigrate::statistics {

namespace {

/// From 1; of equal values the mean of theirs.
std::vector<double> ranks(const std::vector<double>& x) {
  std::vector<double> all;
  for (const double value : x) {
    const auto below = std::ranges::count_if(x, [&](double other) { return other < value; });
    const auto equal = std::ranges::count(x, value);
    all.push_back(static_cast<double>(below) + 0.5 * (static_cast<double>(equal) + 1.0));
  }
  return all;
}

/// From the mean; exactly 0 where all values are the same.
std::vector<double> deviations(const std::vector<double>& x) {
  const auto [low, high] = std::ranges::minmax(x);
  const double mean = low == high ? low : moments(x).mean;
  std::vector<double> all;
  for (const double value : x) all.push_back(value - mean);
  return all;
}

/// Two-sided p of r, whose t has this many degrees of freedom.
double p_of(double r, double df) {
  const double rest = 1.0 - r * r;
  return rest > 0.0 ? t_two_sided(r * std::sqrt(df / rest), df) : 0.0;
}

/// The pairs of which both values are finite.
std::pair<std::vector<double>, std::vector<double>> finite_pairs(Values x, Values y) {
  if (x.size() != y.size()) throw std::invalid_argument("a correlation of samples of different length");
  std::vector<double> u, v;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    u.push_back(x[i]);
    v.push_back(y[i]);
  }
  return {u, v};
}

} // namespace

Correlation pearson(Values x, Values y) {
  const auto [u, v] = finite_pairs(x, y);
  const double x_mean = moments(u).mean, y_mean = moments(v).mean;
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    xx += (u[i] - x_mean) * (u[i] - x_mean);
    yy += (v[i] - y_mean) * (v[i] - y_mean);
    xy += (u[i] - x_mean) * (v[i] - y_mean);
  }
  Correlation c{u.size(), undefined, undefined};
  if (!(xx > 0.0 && yy > 0.0)) return c;
  c.r = std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
  if (c.n >= 3) c.p = p_of(c.r, static_cast<double>(c.n) - 2.0);
  return c;
}

Interval correlation_interval(const Correlation& found, double alpha) {
  if (found.n < 4 || !(std::abs(found.r) < 1.0)) return {found.r, undefined, undefined};
  const double reach = normal_quantile(1.0 - 0.5 * alpha) / std::sqrt(static_cast<double>(found.n) - 3.0);
  const double z = std::atanh(found.r);
  return {found.r, std::tanh(z - reach), std::tanh(z + reach)};
}

Correlation spearman(Values x, Values y) {
  const auto [u, v] = finite_pairs(x, y);
  return pearson(ranks(u), ranks(v));
}

Correlation pearson_within(Values x, Values y, const std::vector<std::size_t>& group) {
  if (x.size() != y.size() || x.size() != group.size())
    throw std::invalid_argument("a correlation of samples of different length");
  std::map<std::size_t, std::pair<std::vector<double>, std::vector<double>>> pairs;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    pairs[group[i]].first.push_back(x[i]);
    pairs[group[i]].second.push_back(y[i]);
  }
  std::vector<double> u, v;
  std::size_t groups = 0;
  for (const auto& [of, both] : pairs) {
    if (both.first.size() < 2) continue;
    ++groups;
    std::ranges::copy(deviations(both.first), std::back_inserter(u));
    std::ranges::copy(deviations(both.second), std::back_inserter(v));
  }
  Correlation c = pearson(u, v);
  c.p = c.n < groups + 2 || std::isnan(c.r) ? undefined : p_of(c.r, static_cast<double>(c.n - groups) - 1.0);
  return c;
}

} // namespace matrigrate::statistics
