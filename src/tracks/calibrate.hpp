#pragma once

#include "tracks/findings.hpp"
#include "tracks/options.hpp"
#include "tracks/spots.hpp"

/// From the units of a file to um and s. Nothing is guessed: what neither the file nor the caller states is a fault.
/// What the caller states counts; if the file states another, a note says so. Test:
/// tests/unit/tracks/reading_test.cpp
namespace matrigrate::tracks {

/// What the positions of a file were multiplied with.
struct Scales {
  double um_per_unit = 1.0;
  double s_per_unit = 1.0; ///< of t, or of the number of the frame
  bool by_frame = false;   ///< times are frame x s_per_unit
};

/// Turns x and y into um, and t into s.
Scales calibrate(Spots& spots, const TrackOptions& options, Findings& findings);

} // namespace matrigrate::tracks
