#include "tracks/layouts.hpp"
#include "tracks/options.hpp"
#include "tracks/spots.hpp"
#include "unit/tracks/reading.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace matrigrate::tracks {
namespace {

// Units that the file states, and those that the caller gives. 5 um in 300 s: 60 um/h.

TrackOptions given(std::optional<double> pixel, std::optional<double> interval, std::string unit = {}) {
  TrackOptions options;
  options.pixel = pixel;
  options.interval = interval;
  options.time_unit = std::move(unit);
  options.shortest = 2;
  options.fewest = 1;
  return options;
}

constexpr std::nullopt_t none = std::nullopt;

TEST(TrackLength, IsStatedOrGivenAndWhatIsGivenCounts) {
  const std::string um = "track,t_s,x_um,y_um\n1,0,0,0\n1,300,3,4\n", bare = "track,t_s,x,y\n1,0,0,0\n1,300,3,4\n";
  EXPECT_EQ(speed(of_text(um, given(none, none))), 60.0);
  EXPECT_EQ(speed(of_text(um, given(1.0, none))), 60.0) << "the same";
  EXPECT_DOUBLE_EQ(speed(of_text(um, given(0.65, none))), 39.0);
  EXPECT_TRUE(notes(of_text(um, given(0.65, none)),
                    "the file says that x_um is in um; it is taken as 0.65 um per unit, as given"));
  EXPECT_EQ(faults(bare, given(none, none)),
            "f: does not state the unit of x and y: give {pixel UM}, um per unit (1 if um)");
  EXPECT_EQ(speed(of_text(bare, given(0.5, none))), 30.0);
}

/// TrackMate with one line of header, in seconds and frames: neither states its unit.
TEST(TrackTime, OfTwoColumnsIsNotGuessed) {
  const std::string both = "TRACK_ID,POSITION_X,POSITION_Y,POSITION_T,FRAME\n0,0,0,0,0\n0,3,4,300,1\n";
  EXPECT_EQ(
      faults(both, given(1.0, none)),
      "f: does not state the unit of POSITION_T: give {time-unit s} (or min), or {interval S}, s from FRAME to FRAME");
  EXPECT_EQ(faults(both, given(1.0, 1.0)),
            "f: POSITION_T rises by 300 from frame to frame, and its unit is not stated: give {time-unit s} (or min) "
            "and no {interval}, or {columns frame=FRAME} if POSITION_T is wrong");
  EXPECT_EQ(speed(of_text(both, given(1.0, 300.0))), 60.0);
  EXPECT_EQ(speed(of_text(both, given(1.0, none, "s"))), 60.0);
  TrackOptions frames = given(1.0, 600.0);
  frames.columns.frame = "FRAME";
  EXPECT_EQ(speed(of_text(both, frames)), 30.0);
  const std::string minutes = "track,frame,t,x_um,y_um\n1,0,0,0,0\n1,1,5,3,4\n";
  EXPECT_NE(faults(minutes, given(none, 60.0)), "none");
  EXPECT_EQ(speed(of_text(minutes, given(none, 300.0))), 60.0);
  EXPECT_EQ(speed(of_text(minutes, given(none, none, "min"))), 60.0);
}

TEST(TrackTime, ThatTheFileStatesIsOverruledWithANote) {
  const std::string seconds =
      "TRACK_ID,POSITION_X,POSITION_Y,POSITION_T,FRAME\nt,X,Y,T,F\nt,X,Y,T,F\n,(micron),(micron),(sec),\n"
      "0,0,0,0,0\n0,3,4,1,1\n";
  const Tracks right = of_text(seconds, given(none, 300.0));
  EXPECT_EQ(speed(right), 60.0);
  EXPECT_TRUE(notes(right, "POSITION_T says 1 s from frame to frame; it is taken as 300 s, as given"));
  EXPECT_TRUE(
      notes(of_text(seconds, given(none, none)), "18000 um/h is faster than cells crawl: are the units right?"));
  EXPECT_TRUE(notes(of_text(seconds, given(none, none, "min")),
                    "the file says that POSITION_T is in sec; it is taken as in min, as given"));
  const std::string alone = "track,t_s,x_um,y_um\n1,0,0,0\n1,1,3,4\n";
  EXPECT_EQ(speed(of_text(alone, given(none, 300.0))), 60.0);
  EXPECT_TRUE(notes(of_text(alone, given(none, 300.0)),
                    "t_s says 1 s from position to position; it is taken as 300 s, as given"));
}

TEST(TrackTime, OfFramesNeedsTheInterval) {
  const std::string frames = "particle,frame,x,y\n1,0,0,0\n1,2,3,4\n";
  EXPECT_EQ(faults(frames, given(1.0, none)),
            "f: its times are numbers of frames (frame): give {interval S}, s from frame to frame");
  EXPECT_EQ(faults(frames, given(1.0, none, "s")).find("f: {time-unit}: there is no column of time; give {interval S}"),
            0U);
  const Tracks every_second = of_text(frames, given(1.0, 150.0));
  EXPECT_EQ(speed(every_second), 60.0);
  EXPECT_TRUE(notes(every_second, "frame rises by 2 from position to position: positions are every 300 s"));
  EXPECT_EQ(faults("particle,frame,x,y\n1,0,0,0\n1,0.5,3,4\n", given(1.0, 150.0)),
            "f:3:1: frame: 0.5 is no whole number, as frames have");
  const std::string named = "TRACK_ID,POSITION_X,POSITION_Y,POSITION_T\n,(um),(um),(frame)\n0,0,0,0\n0,3,4,1\n";
  EXPECT_EQ(speed(of_text(named, given(none, 300.0))), 60.0);
}

TEST(TrackNumbers, WithoutBoundAreRefused) {
  const std::string head = "track,t_s,x_um,y_um\n1,0,0,0\n";
  EXPECT_EQ(faults(head + "1,300,1e308,0\n", given(none, none)),
            "f:3:1: a position of 1e+308 um is out of range; allowed is 1e+09 um on either side");
  EXPECT_EQ(faults(head + "1,1e11,1,0\n", given(none, none)),
            "f:3:1: a time of 1e+11 s is out of range; allowed is 1e+10 s");
}

// Tracks at one interval.

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
            "f:5:1: track a has a step of 30 s, most have 60 s: one interval is needed, within 10 % ({jitter 0.1})");
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
            "f: has 1 track of at least 3 positions; 2 are needed to tell how cells differ ({shortest}, "
            "{fewest})");
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
            "begins. Tell movies apart by a column, {columns group=NAME}, or read each by itself; {columns "
            "group=none} if these are the same cells");
  TrackOptions same_cells = by_minute;
  same_cells.columns.group = {"none"};
  EXPECT_EQ(
      of_text(table({}), same_cells).notes.back(),
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
  EXPECT_NE(shifted.notes.back().find("did the stage move? {drift true}"), std::string::npos);
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
  EXPECT_NE(told.find("do ids repeat in several movies? {columns group=mouse} tells them apart"), std::string::npos)
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

TEST(TrackColumns, KeysAndNames) {
  ColumnNames names;
  add_columns("track=Track n\u00b0,t=Time, of frame [s],x=X [\u00b5m],group=Well,group=Day", names);
  EXPECT_EQ(names.track, "Track n\u00b0");
  EXPECT_EQ(names.t, "Time, of frame [s]") << "a comma that no key follows is one of the name";
  EXPECT_EQ(names.x, "X [\u00b5m]");
  EXPECT_EQ(names.group, (std::vector<std::string>{"Well", "Day"}));
  add_columns("y=Y", names);
  EXPECT_EQ(names.y, "Y");
  EXPECT_THROW(add_columns("y=Z", names), std::invalid_argument) << "named twice";
  EXPECT_THROW(add_columns("z=", names), std::invalid_argument);
  EXPECT_THROW(add_columns("place=X", names), std::invalid_argument);
}

TEST(TrackOptions, OutOfRange) {
  TrackOptions options;
  EXPECT_TRUE(faults_of(options).empty());
  options.pixel = 0.0;
  options.interval = -1.0;
  options.jitter = 0.5;
  options.time_unit = "sec";
  options.layout = "imarys";
  EXPECT_EQ(faults_of(options).size(), 5U);
}

TEST(TrackOptions, AreWordedByWhoAsks) {
  TrackOptions options;
  EXPECT_EQ(options.say("columns", "track=A,t=2") + options.say("interval"), "{columns track=A,t=2}{interval}");
  options.wording = [](std::string_view option, std::string_view value) {
    return std::string(option) + "=" + std::string(value);
  };
  EXPECT_EQ(options.say("interval", "S"), "interval=S");
}

TEST(ColumnTitles, NamesAndUnits) {
  const auto is = [](std::string_view written, std::string_view name, std::string_view unit) {
    const ColumnTitle title = column_title(written);
    EXPECT_EQ(title.name, name) << written;
    EXPECT_EQ(title.unit, unit) << written;
  };
  is("x_um", "x", "um");
  is("POSITION_X", "position_x", "");
  is(" Time [min] ", "time", "min");
  is("X (\u00b5m)", "x", "\u00b5m");
  is("Track n\u00b0", "track n", "");
  is("t_frame", "t", "frame");
  is("(px)", "(px)", "");
  is("", "", "");
}

TEST(TrackUnits, AreKnownOrNot) {
  for (const char* unit : {"um", "\u00b5m", "\u03bcm", "(micron)", "[UM]"}) EXPECT_EQ(length_unit(unit), 1.0) << unit;
  EXPECT_EQ(length_unit("nm"), 1e-3);
  EXPECT_EQ(length_unit("pixel"), std::nullopt);
  EXPECT_EQ(time_unit("(Sec)"), 1.0);
  EXPECT_EQ(time_unit("hours"), 3600.0);
  EXPECT_EQ(time_unit("frame"), std::nullopt);
  EXPECT_TRUE(counts_frames("(frame)"));
}

std::string xml(const std::string& attributes, const std::string& end = "</Tracks>\n") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- TrackMate --><Tracks nTracks=\"1\" " + attributes
         + ">\n  <particle nSpots=\"2\">\n    <detection t=\"0\" x=\"0\" y=\"0\" z=\"0\" />\n"
           "    <detection t='1' x='3.0' y='4.0' z='0'/>\n  </particle>\n"
         + end;
}

TEST(TrackMateXml, IsCalibratedByItselfOrByTheCaller) {
  EXPECT_EQ(speed(of_text(xml("spaceUnits=\"micron\" frameInterval=\"5\" timeUnits=\"min\""), few())), 60.0);
  EXPECT_EQ(speed(of_text(xml("spaceUnits=\"&#181;m\" frameInterval=\"300.0\" timeUnits=\"sec\""), few())), 60.0);
  const std::string plain = xml("spaceUnits=\"pixel\" frameInterval=\"1.0\" timeUnits=\"sec\"");
  EXPECT_EQ(speed(of_text(plain, few(calibrated(0.5, 300.0)))), 30.0);
  TrackOptions pixel;
  pixel.pixel = 0.5;
  EXPECT_EQ(faults(plain, few(pixel)),
            "f: its movie was not calibrated: x is in no unit of length, and a frame lasts 1 s "
            "(frameInterval): give {interval S}, s from frame to frame, or {time-unit s} if it is 1 s");
  TrackOptions interval;
  interval.interval = 300.0;
  const std::string wrong = xml("spaceUnits=\"um\" frameInterval=\"1.0\" timeUnits=\"sec\"");
  EXPECT_TRUE(notes(of_text(wrong, few(interval)),
                    "frameInterval says 1 s from frame to frame; it is taken as 300 s, as given"));
  EXPECT_EQ(speed(of_text(wrong, few(interval))), 60.0);
  EXPECT_EQ(
      speed(of_text(xml("spaceUnits=\"um\" frameInterval=\"1.0\" timeUnits=\"frame\""), few(calibrated(1.0, 300.0)))),
      60.0);
}

TEST(TrackMateXml, WhatIsDamagedIsTold) {
  EXPECT_EQ(faults(xml("spaceUnits=\"um\" frameInterval=\"5\" timeUnits=\"s\"", "")),
            "f:6:1: is cut short: </Tracks> is missing");
  EXPECT_EQ(faults("<TrackMate version=\"7\"></TrackMate>"),
            "f:1:1: its root is <TrackMate>; TrackMate's \"Export tracks to XML file\" writes <Tracks>");
  EXPECT_EQ(faults("<html><body>"),
            "f:1:1: its root is <html>; TrackMate's \"Export tracks to XML file\" writes <Tracks>");
  EXPECT_EQ(faults("<Tracks><particle><detection t=\"0\" x=\"1e\" y=\"2\"/></particle></Tracks>"),
            "f:1:1: x: \"1e\" is no finite number");
  EXPECT_EQ(faults("<Tracks a"), "f: is no XML: the tag <Tracks> has an attribute that is none");
  EXPECT_EQ(faults("<Tracks></Tracks>"), "f: has no position in a track");
}

TEST(MTrackJ, TracksOfClusters) {
  const std::string text = "MTrackJ 1.5.1 Data File\nDisplaying true 1 2\nAssembly 1 FF0000\nCluster 1 FF0000\n"
                           "Track 1 FF0000 true\nPoint 1 0.0 0.0 1.0 1.0 1.0\nPoint 2 3.0 4.0 1.0 2.0 1.0\n"
                           "Cluster 2\nTrack 1\nPoint 1 7 7 1 4 1\nPoint 2 7 8 1 5 1\n";
  const std::string end = "End of MTrackJ Data File\n";
  const Tracks cells = of_text(text + end, few(calibrated(2.0, 60.0)));
  ASSERT_EQ(cells.tracks.size(), 2U);
  EXPECT_EQ(cells.tracks[0].name, "1/1");
  EXPECT_EQ(cells.tracks[1].name, "2/1");
  EXPECT_EQ(cells.tracks[1].start, 240.0);
  EXPECT_EQ(speed(cells), (600.0 + 120.0) / 2);
  const Tracks two =
      of_text(text + "Assembly 2 FF0000\nCluster 1\nTrack 1\nPoint 1 9 9 1 7 1\nPoint 2 9 8 1 8 1\n" + end,
              few(calibrated(2.0, 60.0)));
  ASSERT_EQ(two.tracks.size(), 3U);
  EXPECT_EQ(two.tracks[2].name, "2/1/1");
  EXPECT_EQ(faults(text + end, few()),
            "f: x and y are in pixel: give {pixel UM}, um per pixel\n"
            "f: its times are numbers of frames (t): give {interval S}, s from frame to frame");
  EXPECT_EQ(faults(text, few()), "f:11:1: is cut short: its last line is not \"End of MTrackJ Data File\"");
  EXPECT_EQ(faults("MTrackJ 1.5.1 Data File\nPoint 1 0 0 1 1 1\nTrack 1\nPoint 2 0 0\nPoint 3 a 0 1 1 1\n" + end),
            "f:2:1: has a point in no track\nf:4:1: has 4 words; Point ID x y z t are wanted\n"
            "f:5:1: x: \"a\" is no finite number");
}

TEST(TrackRows, EachFaultHasItsLine) {
  const std::string columns = "track,t_s,x_um,y_um,dummy\n1,0,0,0,False\n";
  EXPECT_EQ(faults(columns + "1,60,1_000,0,False\n1,120,1,0x1,False\n1,180,1,1,maybe\n1,240,1\n1,300,\"1,1,1\n", few()),
            "f:3:1: x_um: \"1_000\" is no finite number\nf:4:1: y_um: \"0x1\" is no finite number\n"
            "f:5:1: dummy: \"maybe\" is neither true nor false\nf:6:1: has 3 fields, the header 5\n"
            "f:7:1: has a quote that is not closed");
}

TEST(TrackRows, CommasAsDecimalSigns) {
  EXPECT_EQ(faults("track,t_s,x_um,y_um\n0,0,230,865,70,367\n", few()),
            "f:2:1: has 6 fields, the header 4: if commas are decimal signs, save it with semicolons or tabs between "
            "columns, or with "
            "points in numbers");
  EXPECT_EQ(faults("track;t_s;x_um;y_um\n0;0;1,5;1.5\n0;60;1;1\n", few()),
            "f:2:1: has numbers with a comma, 1,5, and others with a point, 1.5: write points alone");
  EXPECT_EQ(of_text("track;t_s;x_um;y_um\n0;0;1,5;0\n0;60;1;1\n", few()).tracks[0].x[0], 1.5);
}

TEST(TrackRows, InNoTrackAreLeftOut) {
  const Tracks cells = of_text("TRACK_ID,POSITION_X,POSITION_Y,FRAME\nNone,5,5,0\n0,0,0,0\n0,1,1,1\n,1,1,1\n",
                               few(calibrated(1.0, 60.0)));
  EXPECT_EQ(cells.positions(), 2U);
  EXPECT_TRUE(notes(cells, "2 positions in no track (id None, empty) are left out"));
}

TEST(TrackRows, ThatWereNotMeasuredAreMissing) {
  TrackOptions options = few();
  add_columns("measured=seen", options.columns);
  EXPECT_EQ(of_text("track,t_s,x_um,y_um,seen\n0,0,0,0,1\n0,60,1,1,0\n0,120,2,2,1\n0,180,2,2,1\n0,240,2,3,1\n", options)
                .missing(),
            1U);
}

TEST(TrackInterval, MayBeLonger) {
  const Tracks cells = of_text("track,t_s,x_um,y_um\n0,0,0,0\n0,60,1,0\n0,120,2,0\n0,180,3,0\n", few());
  const Tracks sparse = at_interval(cells, 120.0, "f");
  EXPECT_EQ(sparse.interval, 120.0);
  EXPECT_EQ(sparse.tracks[0].x, (std::vector<double>{0, 2}));
  EXPECT_THROW(at_interval(cells, 90.0, "f"), ConfigurationError);
}

TEST(PlainTracks, AreReadBackTheSame) {
  const Tracks cells = of_text(
      "track,t_s,x_um,y_um\n\"a,b\",30,0.1,0\n\"a,b\",90,1,0.25\nc \"d\",30,2,0\nc \"d\",150,3,0\nc \"d\",210,3,0\n",
      few());
  const Tracks again = of_text(plain_csv(cells), few());
  EXPECT_EQ(plain_csv(again), plain_csv(cells));
  EXPECT_EQ(again.tracks[0].name, "a,b");
  const Tracks formulas = of_text("track,t_s,x_um,y_um\n=1+1,0,0,0\n=1+1,60,1,0\n@x,0,0,0\n@x,60,1,0\n", few());
  EXPECT_EQ(plain_csv(formulas), "track,t_s,x_um,y_um\n'=1+1,0,0,0\n'=1+1,60,1,0\n'@x,0,0,0\n'@x,60,1,0\n");
  EXPECT_EQ(of_text(plain_csv(formulas), few()).tracks[0].name, "=1+1");
}

} // namespace
} // namespace matrigrate::tracks
