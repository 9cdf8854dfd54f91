#pragma once

#include "statistics/compare.hpp"
#include "statistics/sample.hpp"

#include <cstddef>
#include <cstdint>

/// What the elementary effects of a factor say of it. Test: tests/unit/statistics/bootstrap_test.cpp
namespace matrigrate::statistics {

/// Of the elementary effects EE_t of a factor, one a trajectory (Morris 1991, Technometrics 33: 161; Campolongo,
/// Cariboni and Saltelli 2007, Environ Model Softw 22: 1509):
///   mu = mean EE_t,  mu* = mean |EE_t|,  sigma = standard deviation of EE_t
struct ElementaryEffects {
  std::size_t n = 0; ///< effects that are defined
  Interval mu;       ///< NaN for n = 0
  Interval mu_star;  ///< likewise
  Interval sigma;    ///< NaN for n < 2
};

/// With intervals by the bootstrap over trajectories, which are NaN for n < 2.
/// @param effects  one a trajectory; NaN where not defined
/// @param key      of the draws
ElementaryEffects elementary_effects(Values effects, std::uint64_t key, double alpha);

} // namespace matrigrate::statistics
