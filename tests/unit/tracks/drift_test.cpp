#include "tracks/drift.hpp"

#include "unit/tracks/reading.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <stdexcept>

namespace matrigrate::tracks {
namespace {

/// Cells on a stage that drifts by 2 um a minute; cell c goes (c - 2) um a minute itself.
std::string drifting(int cells, int positions, int of_last) {
  std::string text = "track,t_s,x_um,y_um\n";
  for (int c = 0; c < cells; ++c)
    for (int k = 0; k < (c + 1 == cells ? of_last : positions); ++k)
      text += fmt::format("{},{},{},0\n", c, 60 * k, 2 * k + (c - 2) * k);
  return text;
}

TEST(TrackDrift, IsTakenAway) {
  Tracks cells = of_text(drifting(5, 3, 3), few());
  take_drift_away(cells);
  EXPECT_EQ(cells.tracks[2].x, (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(cells.tracks[4].x, (std::vector<double>{0, 2, 4}));
  EXPECT_EQ(cells.notes.back(), "a drift of 4 um is taken away, the mean motion of 5 tracks from 0 to 120 s");
}

TEST(TrackDrift, IsNoneWhereFewTracksGoOn) {
  Tracks cells = of_text(drifting(5, 3, 6), few());
  take_drift_away(cells);
  EXPECT_EQ(cells.tracks[4].x, (std::vector<double>{0, 2, 4, 8, 12, 16})) << "its own way is no drift";
  EXPECT_EQ(cells.notes.back(), "a drift of 4 um is taken away, the mean motion of 5 tracks from 0 to 120 s; none from "
                                "120 to 300 s, where fewer than 5 go on");
}

TEST(TrackDrift, OfTracksThatAreNeverTogetherIsRefused) {
  Tracks cells = of_text(drifting(4, 3, 3), few());
  EXPECT_THROW(take_drift_away(cells), std::invalid_argument);
  std::string text = "track,t_s,x_um,y_um\n";
  for (int c = 0; c < 6; ++c)
    for (int k = 0; k < 3; ++k) text += fmt::format("{},{},{},0\n", c, 60 * (k + 2 * (c / 3)), k);
  cells = of_text(text, few());
  EXPECT_THROW(take_drift_away(cells), std::invalid_argument) << "six, but three at a time";
  EXPECT_TRUE(drift_of(cells).said.empty());
}

} // namespace
} // namespace matrigrate::tracks
