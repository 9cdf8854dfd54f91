#pragma once

#include "tracks/read_tracks.hpp"

/// From positions at times to tracks at one interval. Test: tests/unit/tracks/reading_test.cpp
namespace matrigrate::tracks {

/// @param spots  calibrated: um and s
/// @param exact  whether times are multiples of the interval from frame to frame, not time stamps
/// Sets tracks and interval. A step that is no whole multiple of the interval within options.jitter is a fault, and so
/// is a track that splits, unless options.splits says what is done with it.
void put_on_grid(const Spots& spots, bool exact, const TrackOptions& options, Tracks& tracks, Findings& findings);

} // namespace matrigrate::tracks
