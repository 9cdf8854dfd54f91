#include "unit/tracks/reading.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

/// Tracks at one interval.
namespace matrigrate::tracks {
namespace {

const std::string head = "track,t_s,x_um,y_um\n";

TEST(TrackGrid, GapsStayGaps) {
  const Tracks cells = of_text(
      head + "a,0,0,0\na,60,1,0\na,240,4,0\na,300,4,1\n1.0,60,0,0\n1.0,120,0,NaN\n1.0,180,,\n1.0,240,1,1\n", few());
  ASSERT_EQ(cells.tracks.size(), 2U);
  EXPECT_EQ(cells.tracks[0].k, (std::vector<std::size_t>{0, 1, 4, 5}));
  EXPECT_EQ(cells.missing(), 4U);
  EXPECT_TRUE(notes(cells, "2 rows without a position are missing positions"));
  EXPECT_TRUE(notes(cells, "4 positions are missing within tracks; gaps are not filled"));
  EXPECT_EQ(cells.tracks[1].name, "1") << "an id that was read as a number";
  EXPECT_EQ(cells.tracks[1].start, 60.0);
}

TEST(TrackGrid, RowsInAnyOrder) {
  EXPECT_EQ(of_text(head + "a,120,2,0\na,0,0,0\na,60,1,0\n", few()).tracks[0].x, (std::vector<double>{0, 1, 2}));
}

TEST(TrackGrid, AStepOfItsOwnIsALineOfItsTrack) {
  EXPECT_EQ(faults(head + "a,0,0,0\na,60,1,0\na,120,2,0\na,150,2,0\na,160,2,0\nb,0,0,0\nb,60,1,0\nb,120,1,0\n", few()),
            "f:5:1: track a has a step of 30 s, most have 60 s: one interval is needed, within 10 % (--jitter 0.1)");
  EXPECT_EQ(faults(head
                       + "a,0,0,0\na,60,1,0\na,120,2,0\nb,0,0,0\nb,120,1,0\nb,240,1,0\nb,360,1,0\nb,480,1,0\nb,600,1,"
                         "0\na,180,2,2\na,240,2,2\na,300,2,2\na,360,2,2\n",
                   few()),
            "f:6:1: track b has steps of 120 s and more, most have 60 s: one interval is needed");
  EXPECT_EQ(faults(head + "a,0,0,0\na,60,1,0\na,120,1,0\na,60000000,2,0\n", few()),
            "f:5:1: track a spans more than 100000 intervals of 60 s");
}

TEST(TrackGrid, TimesMayBeRounded) {
  const auto rounded = [](double interval, const char* title, int digits, double unit) {
    std::string text = fmt::format("track,{},x_um,y_um\n", title);
    for (int cell = 0; cell < 3; ++cell)
      for (int k = 0; k < 20; ++k)
        text += fmt::format("{},{:.{}f},{},0\n", cell, (k + cell) * interval / unit, digits, k);
    return text;
  };
  const Tracks cells = of_text(rounded(120.0, "t_h", 2, 3600.0), few());
  EXPECT_EQ(cells.interval, 120.0);
  EXPECT_EQ(cells.missing(), 0U);
  EXPECT_TRUE(notes(cells, "times are rounded to 36 s: positions are taken as every 120 s"));
  EXPECT_EQ(of_text(rounded(150.0, "t_min", 0, 60.0), few()).interval, 150.0);
  EXPECT_EQ(of_text(rounded(300.0, "t_h", 2, 3600.0), few()).interval, 300.0);
  EXPECT_NE(faults(rounded(60.0, "t_h", 2, 3600.0), few()), "none") << "too coarse";
  EXPECT_NE(
      faults("track,t_min,x_um,y_um\na,0,0,0\na,3,1,0\na,6,1,0\na,10,2,2\na,14,3,3\na,18,3,3\na,21,3,3\na,24,3,3\n",
             few()),
      "none")
      << "rounding does not add up";
}

TEST(TrackGrid, TracksOutOfPhaseKeepTheirTimes) {
  const Tracks cells =
      of_text(head + "a,0,0,0\na,60,1,0\na,120,1,1\nb,30,0,0\nb,90,1,0\nb,150,2,0\nc,62,0,0\nc,122,1,0\n", few());
  EXPECT_EQ(cells.tracks[1].start, 30.0);
  EXPECT_EQ(cells.tracks[2].start, 60.0) << "within the tolerance";
  EXPECT_TRUE(notes(cells, "1 track begins between the times of the others, and keeps its own times"));
  EXPECT_NE(plain_csv(cells).find("b,30,0,0\nb,90,1,0\n"), std::string::npos);
}

TEST(TrackGrid, ShortAndFewAndStillTracks) {
  TrackOptions options = few();
  options.shortest = 3;
  options.fewest = 2;
  const std::string one = "a,0,0,0\na,60,1,0\na,120,1,0\nb,0,0,0\nb,60,1,0\n";
  EXPECT_EQ(faults(head + one, options),
            "f: has 1 track of at least 3 positions; 2 are needed to tell how cells differ (--shortest, "
            "--fewest)");
  options.fewest = 1;
  EXPECT_TRUE(notes(of_text(head + one, options), "1 track of fewer than 3 positions is left out"));
  EXPECT_EQ(faults(head + "a,0,1,1\na,60,1,1\n", few()), "f: no track moves: all positions of a track are the same");
}

TEST(TrackGrid, TwoMoviesInOneTableAreNoSplits) {
  std::string two = "movie,track,t_s,x_um,y_um\n";
  for (const char* movie : {"A", "B"})
    for (const char* track : {"1", "2"})
      for (const int k : {0, 1, 2})
        two += std::string(movie) + "," + track + "," + std::to_string(60 * k) + "," + std::to_string(k) + ",0\n";
  const Tracks cells = of_text(two, few());
  EXPECT_EQ(cells.tracks.size(), 4U);
  EXPECT_EQ(cells.tracks[3].name, "B/2");
  EXPECT_TRUE(notes(cells, "ids repeat: tracks are kept apart by movie"));
  // A file for each picture names no movies.
  std::string pictures = "file,track,t_s,x_um,y_um\n";
  for (const int k : {0, 1, 2})
    pictures += "p" + std::to_string(k) + ".tif,1," + std::to_string(60 * k) + "," + std::to_string(k) + ",0\n";
  EXPECT_EQ(of_text(pictures, few()).tracks.size(), 1U);
}

} // namespace
} // namespace matrigrate::tracks
