#pragma once

#include "observe/frame.hpp"
#include "observe/tracks.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// Times at one interval, which some formats of other programs suppose. Test: tests/unit/observe/motion_test.cpp
namespace matrigrate::observe {

/// How far rising times are evenly spaced.
struct EvenTimes {
  double interval = 0.0;          ///< between the first two; 0 of fewer than two [s]
  std::size_t even = 0;           ///< how many from the first lie at multiples of the interval
  std::size_t all = 0;            ///< times
  double least = 0.0, most = 0.0; ///< interval between neighbours [s]

  bool is_even() const { return even == all; }
  /// The last one alone comes too soon, as where a run ends between two multiples.
  bool but_the_last() const { return even + 1 == all && least < interval; }
  /// "every 5 s", or "unevenly spaced, 5 to 10 s apart".
  std::string text() const;
};

/// Times agree within 1 ms.
EvenTimes even_times(std::span<const double> times);

/// The times of the rows, of all cells together, each once.
std::vector<double> times_of(std::span<const TrackRow> rows);
std::vector<double> times_of(const Film& film);

} // namespace matrigrate::observe
