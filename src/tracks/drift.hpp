#pragma once

#include "tracks/read_tracks.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// The motion that all tracks have in common. Test: tests/unit/tracks/readouts_test.cpp
namespace matrigrate::tracks {

inline constexpr std::size_t least_for_drift = 5; ///< tracks that go on over an interval

/// Sum of the mean steps of the tracks, from the first start on: the drift of the stage, if cells have no common
/// direction of their own. With n tracks its error is their mean step over the root of n. An interval over which fewer
/// than five tracks go on has no drift: there the own way of a cell would be taken for it.
struct Drift {
  std::vector<double> x, y; ///< [um] at 0, 1, 2 ... intervals
  std::string said;         ///< from when to when, and how many tracks stand behind it; empty if no interval has any
};

/// @param file  of the tracks, for the message
/// @throws ConfigurationError if tracks are too far apart in time
Drift drift_of(const Tracks& tracks, const std::string& file = {});

/// Less their drift, with a note of how much it was. It takes a common direction of the cells away, too.
/// @throws ConfigurationError also if at no time enough tracks go on
void take_drift_away(Tracks& tracks, const std::string& file = {});

} // namespace matrigrate::tracks
