#pragma once

#include "statistics/compare.hpp"
#include "statistics/sample.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

/// The bootstrap (Efron 1979, Ann Stat 7: 1): how much an estimate varies if the sample is drawn again from itself.
/// Draws are counter-based, so that intervals are the same each time. Test: tests/unit/statistics/statistics_test.cpp
namespace matrigrate::statistics {

/// Draws that an interval is made of.
inline constexpr std::size_t bootstrap_draws = 1000;

/// Which of n values a draw takes, with replacement: n indices below n.
/// @param key   of the sample; two samples with one key are drawn alike, and stay paired
/// @param draw  number of the draw
std::vector<std::size_t> resampled(std::size_t n, std::uint64_t key, std::size_t draw);

/// The values of a draw.
std::vector<double> picked(Values x, const std::vector<std::size_t>& indices);

/// An estimate with the interval between the quantiles alpha/2 and 1 - alpha/2 of its draws. Draws in which it is not
/// defined are left out; the interval is not defined if they are more than half.
/// @param alpha  1 minus the confidence, in (0, 1)
Interval percentile_interval(double value, Values draws, double alpha);

} // namespace matrigrate::statistics
