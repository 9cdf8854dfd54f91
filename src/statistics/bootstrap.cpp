#include "statistics/bootstrap.hpp"

#include "base/random.hpp"
#include "statistics/distributions.hpp"

#include <cmath>

namespace matrigrate::statistics {

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
