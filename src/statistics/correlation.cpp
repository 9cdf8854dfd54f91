#include "statistics/correlation.hpp"

#include "statistics/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace matrigrate::statistics {

Correlation pearson(Values x, Values y) {
  if (x.size() != y.size()) throw std::invalid_argument("a correlation of samples of different length");
  std::vector<double> u;
  std::vector<double> v;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    u.push_back(x[i]);
    v.push_back(y[i]);
  }
  const double x_mean = moments(u).mean;
  const double y_mean = moments(v).mean;
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    xx += (u[i] - x_mean) * (u[i] - x_mean);
    yy += (v[i] - y_mean) * (v[i] - y_mean);
    xy += (u[i] - x_mean) * (v[i] - y_mean);
  }
  Correlation c{u.size(), undefined, undefined};
  if (!(xx > 0.0 && yy > 0.0)) return c;
  c.r = std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
  if (c.n < 3) return c;
  const double df = static_cast<double>(c.n) - 2.0;
  const double rest = 1.0 - c.r * c.r;
  c.p = rest > 0.0 ? t_two_sided(c.r * std::sqrt(df / rest), df) : 0.0;
  return c;
}

std::vector<std::vector<Correlation>> correlation_matrix(const std::vector<std::vector<double>>& quantities) {
  std::vector<std::vector<Correlation>> matrix;
  for (const auto& x : quantities) {
    std::vector<Correlation>& row = matrix.emplace_back();
    for (const auto& y : quantities) row.push_back(pearson(x, y));
  }
  return matrix;
}

} // namespace matrigrate::statistics
