#include "base/random.hpp"
#include "tracks/read_tracks.hpp"
#include "unit/tracks/reading.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace matrigrate::tracks {
namespace {

Tracks one(std::vector<double> x, std::vector<double> y, double interval = 60.0) {
  Tracks tracks;
  tracks.interval = interval;
  Track& track = tracks.tracks.emplace_back();
  for (std::size_t k = 0; k < x.size(); ++k) track.k.push_back(k);
  track.x = std::move(x);
  track.y = std::move(y);
  return tracks;
}

/// Steps of constant length whose direction is a random walk: persistence time interval / (1 - mean cosine), about.
Tracks persistent(std::size_t cells, std::size_t steps, double turn) {
  Tracks tracks;
  tracks.interval = 60.0;
  for (std::size_t c = 0; c < cells; ++c) {
    Track& track = tracks.tracks.emplace_back();
    double x = 0.0, y = 0.0, angle = 0.0;
    for (std::size_t k = 0; k <= steps; ++k) {
      track.k.push_back(k);
      track.x.push_back(x);
      track.y.push_back(y);
      angle += turn * (2.0 * uniform(7, Purpose::test, k, static_cast<std::uint32_t>(c)) - 1.0);
      x += std::cos(angle);
      y += std::sin(angle);
    }
  }
  return tracks;
}

TEST(TrackReadouts, OfAStraightTrack) {
  std::vector<double> x;
  for (int k = 0; k <= 20; ++k) x.push_back(0.5 * k);
  const Tracks straight = one(x, std::vector<double>(21, 0.0));
  for (const char* name : {"speed_um_per_h", "speed_median_um_per_h", "v_migr_abs_um_per_h"})
    EXPECT_DOUBLE_EQ(readout(straight, name), 30.0) << name;
  for (const char* name : {"straightness", "directionality_ratio", "turning_cosine"})
    EXPECT_DOUBLE_EQ(readout(straight, name), 1.0) << name;
  for (const char* name : {"msd_slope_short", "msd_slope_long"})
    EXPECT_NEAR(readout(straight, name), 2.0, 1e-12) << name;
  EXPECT_EQ(readout(straight, "turning_angle_deg"), 0.0);
  for (const char* name : {"persistence_min", "directionality_time_min", "anisotropy"})
    EXPECT_TRUE(std::isnan(readout(straight, name))) << name;
}

TEST(TrackReadouts, OfASquare) {
  const Tracks square = one({0, 1, 1, 0, 0}, {0, 0, 1, 1, 0});
  EXPECT_EQ(readout(square, "v_migr_abs_um_per_h"), 0.0);
  EXPECT_DOUBLE_EQ(readout(square, "speed_um_per_h"), 60.0);
  EXPECT_DOUBLE_EQ(readout(square, "turning_angle_deg"), 90.0);
  EXPECT_NEAR(readout(square, "turning_cosine"), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(readout(square, "anisotropy"), 1.0);
  EXPECT_TRUE(std::isnan(readout(square, "directionality_ratio"))) << "it needs ten intervals";
  // MSD 1, 2, 1, 0: distance over path 1, sqrt(1/2), 1/3: one half between 2 and 3 intervals.
  const std::vector<std::size_t> all{0};
  EXPECT_EQ(TrackParts(square).msd(all), (std::vector<double>{1, 2, 1, 0}));
  const double half = std::numbers::sqrt2 / 2.0;
  EXPECT_NEAR(readout(square, "directionality_time_min"), 2.0 + (half - 0.5) / (half - 1.0 / 3.0), 1e-12);
}

TEST(TrackReadouts, PairsAcrossAGapOnly) {
  Tracks gap = one({0, 1, 3}, {0, 0, 0});
  gap.tracks[0].k = {0, 1, 3};
  EXPECT_DOUBLE_EQ(readout(gap, "speed_um_per_h"), 60.0) << "the step over the gap is none";
  EXPECT_DOUBLE_EQ(readout(gap, "v_migr_abs_um_per_h"), 60.0);
  const std::vector<std::size_t> all{0};
  EXPECT_EQ(TrackParts(gap).msd(all), (std::vector<double>{1, 4, 9}));
}

TEST(TrackReadouts, PersistenceOfAPersistentWalk) {
  const double turn = 0.6, cosine = std::sin(turn) / turn;
  const Tracks walk = persistent(100, 100, turn);
  EXPECT_NEAR(readout(walk, "turning_cosine"), cosine, 0.003);
  const double time = -1.0 / std::log(cosine); // of the correlation of directions [min]
  EXPECT_NEAR(readout(walk, "persistence_min"), time, 0.1 * time);
  EXPECT_NEAR(readout(walk, "speed_um_per_h"), 60.0, 1e-9);
}

TEST(TrackReadouts, AnErrorOfPositionsIsTakenOffTheMeanSquareDisplacement) {
  const double turn = 0.6, error = 0.5;
  Tracks walk = persistent(100, 100, turn);
  const double clean = readout(walk, "msd_slope_short");
  for (std::size_t c = 0; c < walk.tracks.size(); ++c)
    for (std::size_t k = 0; k < walk.tracks[c].x.size(); ++k) {
      const double r = error * std::sqrt(-2.0 * std::log(uniform(8, Purpose::test, k, static_cast<std::uint32_t>(c))));
      const double phi = 2.0 * std::numbers::pi * uniform(9, Purpose::test, k, static_cast<std::uint32_t>(c));
      walk.tracks[c].x[k] += r * std::cos(phi);
      walk.tracks[c].y[k] += r * std::sin(phi);
    }
  const auto slope = static_cast<std::size_t>(
      std::ranges::find(track_readouts, std::string_view("msd_slope_short"), &ReadoutMeaning::name)
      - track_readouts.begin());
  EXPECT_LT(TrackParts(walk).readouts()[slope], clean - 0.2);
  EXPECT_NEAR(TrackParts(walk).readouts(error)[slope], clean, 0.03);
}

TEST(TrackReadouts, AnErrorThatExceedsTheMotionDefinesNoSlope) {
  const TrackParts square(one({0, 1, 1, 0, 0, 1}, {0, 0, 1, 1, 0, 0})); // one um in each step
  EXPECT_EQ(square.buried(0.49), "");
  EXPECT_TRUE(square.buried(0.5).starts_with("MSD at one interval, 1 um2, is below 4 error^2 = 1 um2"))
      << square.buried(0.5);
  EXPECT_TRUE(std::isnan(square.readouts(0.5)[9]));
  EXPECT_DOUBLE_EQ(square.readouts(0.5)[0], 60.0) << "speeds stay";
}

TEST(TrackReadouts, StandardErrorsAreThoseOfTheMean) {
  const Tracks walk = persistent(50, 30, 1.0);
  const TrackParts parts(walk);
  const ReadoutValues value = parts.readouts(), errors = standard_errors(value, parts.drawn(0.0, 400));
  double sum = 0.0, square = 0.0;
  for (std::size_t k = 0; k < 50; ++k) {
    const std::vector<std::size_t> own{k};
    const double net = parts.readouts(own, 0.0)[4];
    sum += net;
    square += net * net;
  }
  const double mean = sum / 50.0, error = std::sqrt((square - 50.0 * mean * mean) / 49.0 / 50.0);
  EXPECT_DOUBLE_EQ(value[4], mean);
  EXPECT_NEAR(errors[4], error, 0.1 * error);
  EXPECT_EQ(standard_errors(value, parts.drawn(0.0, 400))[4], errors[4]) << "the same draws each time";
  const TrackParts alone(one({0, 1, 2}, {0, 1, 0}));
  EXPECT_TRUE(std::isnan(standard_errors(alone.readouts(), alone.drawn(0.0, 200))[0])) << "of one track";
}

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
  EXPECT_THROW(take_drift_away(cells), ConfigurationError);
  std::string text = "track,t_s,x_um,y_um\n";
  for (int c = 0; c < 6; ++c)
    for (int k = 0; k < 3; ++k) text += fmt::format("{},{},{},0\n", c, 60 * (k + 2 * (c / 3)), k);
  cells = of_text(text, few());
  EXPECT_THROW(take_drift_away(cells), ConfigurationError) << "six, but three at a time";
  EXPECT_TRUE(drift_of(cells).said.empty());
}

} // namespace
} // namespace matrigrate::tracks
