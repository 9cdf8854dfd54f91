#include "statistics/elementary_effects.hpp"

#include "statistics/bootstrap.hpp"
#include "statistics/distributions.hpp"

#include <array>
#include <cmath>

namespace matrigrate::statistics {

namespace {

/// mu, mu* and sigma.
std::array<double, 3> measures(Values effects) {
  std::vector<double> sizes;
  sizes.reserve(effects.size());
  for (const double effect : effects) sizes.push_back(std::abs(effect));
  const Moments m = moments(effects);
  return {m.mean, moments(sizes).mean, m.sd};
}

} // namespace

ElementaryEffects elementary_effects(Values effects, std::uint64_t key, double alpha) {
  const std::vector<double> defined = finite(effects);
  const std::array<double, 3> found = measures(defined);
  std::array<std::vector<double>, 3> draws;
  for (std::size_t draw = 0; draw < bootstrap_draws && defined.size() > 1; ++draw) {
    const auto again = measures(finite(picked(effects, resampled(effects.size(), key, draw))));
    for (std::size_t k = 0; k < draws.size(); ++k) draws[k].push_back(again[k]);
  }
  const auto interval = [&](std::size_t k) { return percentile_interval(found[k], draws[k], alpha); };
  return {defined.size(), interval(0), interval(1), interval(2)};
}

} // namespace matrigrate::statistics
