#pragma once

#include "tracks/read_tracks.hpp"

#include <span>
#include <vector>

/// Steps that no cell makes: of tracks that go on in another movie. Test: tests/unit/tracks/reading_test.cpp
namespace matrigrate::tracks {

/// From one position of a track to the next one that is there.
struct Step {
  double dx, dy;
  double gap = 1.0; ///< intervals

  /// As of one interval, if the cell walks at random.
  double length() const;
};

/// Median length of the steps over one interval that move at all; 0 if there is none.
double usual_step(std::span<const Step> steps);

/// What steps of several tracks at one time are.
enum class Together {
  walks,
  shifts, ///< the stage moved: all step alike
  leaps   ///< half of them are longer than ten usual steps, nearly all than three
};
/// @param sure  whether a column changes with them: then half of it is enough for steps over one interval
Together together(std::span<const Step> steps, double usual, bool sure = false);

/// Looks for times at which all tracks leap, which is another movie, and for single leaps. A fault if all leap from one
/// interval to the next, unless the caller says that there are no movies; else a note.
void look_for_leaps(const Tracks& tracks, const TrackOptions& options, Findings& findings);

} // namespace matrigrate::tracks
