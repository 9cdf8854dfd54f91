#include "unit/tracks/reading.hpp"

#include <gtest/gtest.h>

/// Files as tracking programs and spreadsheets write them: six cells of 14 positions every 120 s, at 50.835 um/h.
namespace matrigrate::tracks {
namespace {

constexpr double right = 50.8352; ///< [um/h]

struct Kind {
  const char* file;
  const char* layout;
  TrackOptions options;
};

TEST(TrackFiles, OfManyProgramsAreTheSameTracks) {
  const TrackOptions um = calibrated(1.0, 120.0);
  TrackOptions frames;
  frames.interval = 120.0;
  const Kind kinds[] = {{"bom.csv", "plain", {}},
                        {"comma_semicolons.csv", "trackmate", um},
                        {"comma_tabs.csv", "plain", {}},
                        {"trackmate.csv", "trackmate", {}},
                        {"trackmate_windows.csv", "trackmate", {}},
                        {"trackmate_utf16.csv", "trackmate", {}},
                        {"imaris.csv", "imaris", frames},
                        {"mosaic.csv", "mosaic", um},
                        {"jitter.csv", "plain", frames}};
  for (const Kind& kind : kinds) {
    const Tracks cells = of_file(kind.file, kind.options);
    EXPECT_EQ(cells.tracks.size(), 6U) << kind.file;
    EXPECT_EQ(cells.positions(), 84U) << kind.file;
    EXPECT_EQ(cells.interval, 120.0) << kind.file;
    EXPECT_NEAR(speed(cells), right, 1e-3) << kind.file;
    EXPECT_EQ(cells.layout, kind.layout) << kind.file;
  }
  const Tracks rounded = of_file("manual_tracking.txt", um); // to whole pixels
  EXPECT_EQ(rounded.layout, "manual-tracking");
  EXPECT_NEAR(speed(rounded), 52.7, 0.05);
}

TEST(TrackFiles, TellHowTheyWereUnderstood) {
  EXPECT_TRUE(notes(of_file("comma_tabs.csv"), "commas are read as decimal signs: 230,865 is 230.865"));
  EXPECT_TRUE(notes(of_file("trackmate_windows.csv"), "the file is not UTF-8; it is read as Windows-1252"));
  EXPECT_EQ(of_file("trackmate_utf16.csv").encoding, "UTF-16");
  EXPECT_TRUE(of_file("trackmate.csv").notes.empty());
}

TEST(TrackFiles, PositionsThatATrackerMadeUpAreMissing) {
  const TrackOptions um = calibrated(1.0, 120.0);
  const Tracks cells = of_file("btrack.csv", um), seen = of_file("btrack_seen.csv", um);
  EXPECT_EQ(cells.positions(), 156U);
  EXPECT_EQ(cells.missing(), 84U);
  EXPECT_NEAR(speed(cells), 54.25, 0.01);
  EXPECT_NEAR(readout(cells, "turning_cosine"), -0.136, 5e-4);
  EXPECT_EQ(speed(cells), speed(seen));
  EXPECT_TRUE(notes(cells, "84 positions that the tracker made up (dummy) are missing positions"));
  EXPECT_EQ(of_file("btrack_blanks.txt", um).layout, "btrack");
  TrackOptions all = um;
  all.columns.made_up = "none";
  EXPECT_EQ(of_file("btrack.csv", all).positions(), 240U);
}

TEST(TrackFiles, IdsThatRepeatInMoviesAreKeptApart) {
  TrackOptions options = calibrated(1.0, 120.0);
  EXPECT_EQ(of_file("celltrackscolab.csv", options).tracks.size(), 12U) << "by Unique_ID";
  options.layout = "trackmate";
  const Tracks apart = of_file("celltrackscolab.csv", options);
  EXPECT_EQ(apart.tracks.size(), 12U);
  EXPECT_EQ(apart.tracks[0].name, "gelA_movie1/0");
  EXPECT_TRUE(notes(apart, "ids repeat: tracks are kept apart by File_name"));
  options.columns.group = {"none"};
  const std::string told = faults_of_file("celltrackscolab.csv", options);
  EXPECT_NE(told.find("do ids repeat in several movies? {columns group=NAME} tells them apart"), std::string::npos)
      << told;
}

TEST(TrackFiles, ACellThatDividesIsRefusedCutOrLeftOut) {
  EXPECT_EQ(faults_of_file("dividing.csv"),
            "dividing.csv:86:1: track 0 has two positions at 960 s: it splits or merges; {splits "
            "cut} ends it before, {splits drop} leaves it out");
  TrackOptions options;
  options.splits = Splits::cut;
  const Tracks cut = of_file("dividing.csv", options);
  EXPECT_EQ(cut.positions(), 78U);
  EXPECT_TRUE(notes(cut, "1 of 6 tracks splits or merges: cut before it"));
  options.splits = Splits::drop;
  EXPECT_EQ(of_file("dividing.csv", options).tracks.size(), 5U);
}

TEST(TrackFiles, TimesAreNotGuessed) {
  EXPECT_EQ(faults_of_file("celltrackr.csv", calibrated(1.0, 24.0)),
            "celltrackr.csv: t rises by 24 from position to position, and its unit is not stated: give {time-unit s} "
            "(or min) "
            "and no {interval}");
  TrackOptions seconds;
  seconds.pixel = 1.0;
  seconds.time_unit = "s";
  EXPECT_NEAR(speed(of_file("celltrackr.csv", seconds)), 254.18, 0.01);
  EXPECT_EQ(
      faults_of_file("spaces.txt", calibrated(1.0, 120.0)),
      "spaces.txt:1:1: has no header; tell what its 6 columns hold, counted from 1: {columns track=2,t=3,x=4,y=5}");
  add_columns("track=2,t=3,x=4,y=5", seconds.columns);
  EXPECT_NEAR(speed(of_file("spaces.txt", seconds)), 254.18, 0.01);
}

TEST(TrackFiles, AMovieWithoutCalibrationIsCalibratedByTheCaller) {
  const Tracks cells = of_file("uncalibrated.csv", calibrated(0.65, 120.0));
  EXPECT_EQ(cells.interval, 120.0);
  EXPECT_NEAR(speed(cells), 33.04, 0.005);
  TrackOptions pixel;
  pixel.pixel = 0.65;
  EXPECT_EQ(
      faults_of_file("uncalibrated.csv", pixel),
      "uncalibrated.csv: its movie was not calibrated: x is in no unit of length, and a frame lasts 1 s (POSITION_T): "
      "give {interval S}, s from frame to frame, or {time-unit s} if it is 1 s");
  pixel.time_unit = "s";
  EXPECT_TRUE(notes(of_file("uncalibrated.csv", pixel), "3265 um/h is faster than cells crawl: are the units right?"));
}

TEST(TrackFiles, TimeStampsMayScatter) {
  const Tracks cells = of_file("jitter.csv");
  EXPECT_NEAR(cells.interval, 120.0, 0.1);
  EXPECT_NEAR(speed(cells), right, 0.05);
  EXPECT_TRUE(
      notes(cells, "time stamps scatter: steps differ from 120.044 s by 2.6 % (root mean square), at most 7.2 %"));
  TrackOptions strict;
  strict.jitter = 0.01;
  EXPECT_EQ(faults_of_file("jitter.csv", strict),
            "jitter.csv:4:1: track 0 has a step of 119.065 s, the median is 120.439 s: one "
            "interval is needed, within 1 % ({jitter 0.01}) (and 5 more)");
}

} // namespace
} // namespace matrigrate::tracks
