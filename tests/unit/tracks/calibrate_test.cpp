#include "unit/tracks/reading.hpp"

#include <gtest/gtest.h>

/// Units that the file states, and those that the caller gives. 5 um in 300 s: 60 um/h.
namespace matrigrate::tracks {
namespace {

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
            "f: does not state the unit of x and y: give --pixel UM, um per unit (1 if um)");
  EXPECT_EQ(speed(of_text(bare, given(0.5, none))), 30.0);
}

/// TrackMate with one line of header, in seconds and frames: neither states its unit.
TEST(TrackTime, OfTwoColumnsIsNotGuessed) {
  const std::string both = "TRACK_ID,POSITION_X,POSITION_Y,POSITION_T,FRAME\n0,0,0,0,0\n0,3,4,300,1\n";
  EXPECT_EQ(
      faults(both, given(1.0, none)),
      "f: does not state the unit of POSITION_T: give --time-unit s (or min), or --interval S, s from FRAME to FRAME");
  EXPECT_EQ(faults(both, given(1.0, 1.0)),
            "f: POSITION_T rises by 300 from frame to frame, and its unit is not stated: give --time-unit s (or min) "
            "and no --interval, or --columns \"frame=FRAME\" if POSITION_T is wrong");
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
            "f: its times are numbers of frames (frame): give --interval S, s from frame to frame");
  EXPECT_EQ(faults(frames, given(1.0, none, "s")).find("f: --time-unit: there is no column of time; give --interval S"),
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

} // namespace
} // namespace matrigrate::tracks
