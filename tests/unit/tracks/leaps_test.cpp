#include "tracks/leaps.hpp"

#include "unit/tracks/reading.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace matrigrate::tracks {
namespace {

/// How two movies stand in one table: what their rows begin with, and where the second one begins.
struct Movies {
  std::string title{}, first{}, second{}; ///< with a comma at the end, or empty
  int cells = 4, frames = 10;
  int begin = 10;        ///< frame of the second movie
  double apart = 200.0;  ///< [um] of its places
  bool parallel = false; ///< all cells by the same
};

/// Each cell steps 3 um a frame, in directions of its own.
std::string table(const Movies& movies) {
  std::string text = movies.title + "track,frame,x_um,y_um\n", second;
  for (int cell = 0; cell < movies.cells; ++cell) {
    double x = 100.0 * cell, y = 50.0 * (cell % 3);
    const double turn = movies.parallel ? 0.0 : 2.0 * cell;
    for (int k = 0; k < 2 * movies.frames; ++k) {
      const bool later = k >= movies.frames;
      const double angle = 1.7 * k * (cell + 1);
      x += 3.0 * std::cos(angle) + (k == movies.frames ? movies.apart * std::cos(turn) : 0.0);
      y += 3.0 * std::sin(angle) + (k == movies.frames ? movies.apart * std::sin(turn) : 0.0);
      (later ? second : text) += fmt::format("{}{},{},{:.4f},{:.4f}\n", later ? movies.second : movies.first, cell,
                                             later ? k - movies.frames + movies.begin : k, x, y);
    }
  }
  return text + second;
}

const TrackOptions by_minute = few(calibrated(1.0, 60.0));

TEST(Movies, AreToldApartByAnyColumn) {
  for (const char* title : {"mouse", "treatment", "slide", "x0", "\u00c4"}) {
    const Tracks cells =
        of_text(table({.title = title + std::string(","), .first = "a,", .second = "b,"}), few(calibrated(1.0, 60.0)));
    EXPECT_EQ(cells.tracks.size(), 8U) << title;
    EXPECT_NEAR(speed(cells), 180.0, 1e-2) << title;
    EXPECT_TRUE(notes(cells, fmt::format("ids repeat: tracks are kept apart by {}", title)));
  }
  const Tracks two = of_text(table({.title = "day,mouse,", .first = "1,7,", .second = "2,7,"}), by_minute);
  EXPECT_EQ(two.columns.group, (std::vector<std::string>{"day"}));
}

TEST(Movies, WithoutAColumnAreRefused) {
  EXPECT_EQ(faults(table({}), by_minute),
            "f: after 540 s all 4 tracks that go on leap, by 197 to 203 um (the usual step is 3 um): another movie "
            "begins. Tell movies apart by a column, --columns \"group=NAME\", or read each by itself; --columns "
            "\"group=none\" if these are the same cells");
  TrackOptions none = by_minute;
  none.columns.group = {"none"};
  EXPECT_EQ(
      of_text(table({}), none).notes.back(),
      "after 540 s all 4 tracks that go on leap, by 197 to 203 um (the usual step is 3 um): is it another movie?");
  const Tracks paused = of_text(table({.begin = 50}), by_minute);
  EXPECT_NE(paused.notes.back().find("is it another movie?"), std::string::npos) << "after a pause it is only likely";
}

TEST(Movies, AreNotSeenInOne) {
  const Movies still{.title = "drug,", .first = "before,", .second = "after,", .apart = 0.0};
  EXPECT_EQ(of_text(table(still), by_minute).tracks.size(), 4U) << "treated within a movie";
  Movies shift = still;
  shift.apart = 60.0;
  shift.parallel = true;
  shift.frames = 10;
  const Tracks shifted = of_text(table(shift), by_minute);
  EXPECT_EQ(shifted.tracks.size(), 4U);
  EXPECT_NE(shifted.notes.back().find("did the stage move? --drift"), std::string::npos);
  EXPECT_EQ(of_text(table({.title = "plane,", .first = "1,", .second = "1,", .cells = 4, .apart = 0.0}), by_minute)
                .notes.size(),
            0U);
  const Tracks one = of_text(table({.cells = 1}), by_minute);
  EXPECT_EQ(one.notes.back(), "1 step is over ten times the usual one, 3 um; the longest, 199 um, is of track 0 at 600 "
                              "s: a wrong link, or another movie?");
}

TEST(Movies, AreNotSeenWhereLongStepsAreFrequent) {
  std::string text = "track,t_s,x_um,y_um\n";
  for (int cell = 0; cell < 2; ++cell)
    for (int k = 0, x = 0; k < 100; ++k) {
      x += k % 9 == 0 ? 40 : k % (5 + cell) == 0 ? 12 : 1;
      text += fmt::format("{},{},{},{}\n", cell, 60 * k, cell == 0 ? x : 0, cell == 0 ? 0 : x);
    }
  EXPECT_EQ(faults(text, few()), "none") << "cells that rest and run";
}

TEST(Movies, ThatBeginAgainAreToldApartByTheColumnThatIsNamed) {
  const std::string again = table({.title = "mouse,", .first = "a,", .second = "b,", .begin = 0});
  const std::string told = faults(again, by_minute);
  EXPECT_NE(told.find("do ids repeat in several movies? --columns \"group=mouse\" tells them apart"), std::string::npos)
      << told;
  TrackOptions mouse = by_minute;
  mouse.columns.group = {"mouse"};
  EXPECT_EQ(of_text(again, mouse).tracks.size(), 8U);
}

TEST(Movies, OfFilesThatWereJoined) {
  for (const int begin : {0, 10}) {
    std::string text = table({.begin = begin});
    const std::size_t half = text.find(fmt::format("\n0,{},", begin), text.find("\n3,9,")) + 1;
    text.insert(half, "track,frame,x_um,y_um\n");
    const Tracks cells = of_text(text, by_minute);
    EXPECT_EQ(cells.tracks.size(), 8U) << begin;
    EXPECT_NEAR(speed(cells), 180.0, 1e-2);
  }
}

TEST(TrackRows, TwiceCountOnce) {
  const std::string once = table({.apart = 0.0});
  const std::string rows = once.substr(once.find('\n') + 1, 300);
  const std::string twice = once + rows.substr(0, rows.rfind('\n') + 1);
  EXPECT_EQ(plain_csv(of_text(twice, by_minute)), plain_csv(of_text(once, by_minute)));
  EXPECT_TRUE(notes(of_text(once + rows.substr(0, rows.find('\n') + 1), by_minute),
                    "1 row stands there twice, and counts once"));
  const std::string joined = once + once;
  EXPECT_EQ(plain_csv(of_text(joined, by_minute)), plain_csv(of_text(once, by_minute))) << "with its header";
  EXPECT_NE(faults(once + "0,3,500,500\n", by_minute).find("two positions"), std::string::npos);
}

} // namespace
} // namespace matrigrate::tracks
