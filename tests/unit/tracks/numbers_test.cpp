#include "tracks/numbers.hpp"

#include "unit/tracks/reading.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace matrigrate::tracks {
namespace {

/// A cell that goes 1 um along x every 120 s, 30 times, from x = 985 um on.
std::string passing(char separator, const char* thousands) {
  std::string text = fmt::format("track{0}t_s{0}x_um{0}y_um\n", separator);
  const auto number = [&](int value) {
    return value < 1000 ? std::to_string(value) : fmt::format("\"{}{}{:03d}\"", value / 1000, thousands, value % 1000);
  };
  for (int k = 0; k < 30; ++k) text += fmt::format("1{0}{1}{0}{2}{0}0\n", separator, number(120 * k), number(985 + k));
  return text;
}

TEST(TrackNumbers, SignsBetweenThousands) {
  for (const char separator : {'\t', ';', ','})
    for (const char* sign : {",", ".", "'", " ", "\u00a0", "\u202f"}) {
      if (separator == ',' && *sign == '.') continue;
      const Tracks cells = of_text(passing(separator, sign), few());
      EXPECT_EQ(cells.interval, 120.0) << separator << sign;
      EXPECT_DOUBLE_EQ(speed(cells), 30.0) << separator << sign;
    }
  EXPECT_TRUE(notes(of_text(passing(';', "."), few()), "points separate thousands: 1.000 is 1000"));
  EXPECT_TRUE(notes(of_text(passing('\t', ","), few()), "commas separate thousands: 1,080 is 1080")
              || notes(of_text(passing('\t', ","), few()), "commas separate thousands: 1,000 is 1000"));
}

TEST(TrackNumbers, DecimalsOfThreeDigitsAreNoThousands) {
  const std::string three = "track;t_s;x_um;y_um\n1;0;100,000;1,125\n1;60;100,500;1,125\n";
  EXPECT_DOUBLE_EQ(speed(of_text(three, few())), 30.0);
  EXPECT_EQ(of_text("track;t_s;x_um;y_um\n1;0;0;0\n1;60;0.125;0\n1;120;1.125;0\n", few()).tracks[0].x.back(), 1.125);
  EXPECT_EQ(of_text("track,t_s,x_um,y_um\n1,0,0,0\n1,60,1.125,0\n1,120,2.125,0\n", few()).tracks[0].x.back(), 2.125)
      << "with commas between columns a point is a decimal sign";
  EXPECT_EQ(faults("track;t_s;x_um;y_um\n1;0;0;0\n1;60;1.125;0\n", few()),
            "f:3:1: 1.125 may be a thousand or have decimals: write numbers without signs between their thousands");
}

TEST(TrackNumbers, BothSigns) {
  EXPECT_EQ(of_text("track;t_s;x_um;y_um\n1;0;999,5;0\n1;1.200;1.000,25;0\n", few()).tracks[0].x.back(), 1000.25);
  EXPECT_EQ(of_text("track,t_s,x_um,y_um\n1,0,\"133,288\",\"0,5\"\n1,60,\"134,288\",\"0,5\"\n", few()).tracks[0].x[0],
            133.288)
      << "quoted decimal commas";
  EXPECT_EQ(faults("track;t_s;x_um;y_um\n0;0;1,5;1.5\n0;60;1;1\n", few()),
            "f:2:1: has numbers with a comma, 1,5, and others with a point, 1.5: write points alone");
}

TEST(TrackColumns, TwoOfOneMeaning) {
  EXPECT_EQ(faults("track,t_s,x_um,y_um,x_um\n1,0,0,0,0\n1,60,1,0,2\n", few()),
            "f:3:1: x_um stands there twice, and the two contradict each other, 1 and 2: name the right one, --columns "
            "\"x=3\"");
  TrackOptions fifth = few();
  add_columns("x=5", fifth.columns);
  EXPECT_EQ(of_text("track,t_s,x_um,y_um,x_um\n1,0,0,0,0\n1,60,1,0,2\n", fifth).tracks[0].x.back(), 2.0);
  EXPECT_TRUE(notes(of_text("track,t_s,x_um,y_um,x_um\n1,0,0,0,0\n1,60,1,0,1\n", few()),
                    "x_um stands there twice; both say the same"));
  EXPECT_EQ(faults("track,t_min,t_s,x_um,y_um\n1,0,0,0,0\n1,3,120,1,0\n", few()),
            "f:3:1: t_min and t_s contradict each other, 3 and 120: name the right one, --columns \"t=t_min\"");
  EXPECT_TRUE(notes(of_text("track,time (min),t_s,x_um,y_um\n1,0,0,0,0\n1,2,120,1,0\n", few()),
                    "time (min) and t_s say the same")
              || notes(of_text("track,time (min),t_s,x_um,y_um\n1,0,0,0,0\n1,2,120,1,0\n", few()),
                       "t_s and time (min) say the same"));
}

/// The interval [s] of a cell at these times.
double interval(const std::vector<std::string>& times, const std::string& title = "time") {
  std::string text = "track," + title + ",x_um,y_um\n";
  for (std::size_t k = 0; k < times.size(); ++k) text += fmt::format("1,\"{}\",{},0\n", times[k], k);
  return of_text(text, few()).interval;
}

TEST(TrackClock, FormsOfTimes) {
  EXPECT_EQ(interval({"00:00:00", "00:02:00", "00:04:00"}), 120.0);
  EXPECT_EQ(interval({"0:59:00", "1:01:00", "1:03:00"}), 120.0);
  EXPECT_EQ(interval({"00:00.0", "02:00.5", "04:01.0"}), 120.5);
  EXPECT_EQ(interval({"58:00", "59:30", "1:01:00"}), 90.0);
  EXPECT_EQ(interval({"0 days 23:58:00", "1 days 00:00:00", "1 day, 0:02:00"}), 120.0);
  EXPECT_EQ(interval({"2024-05-03 23:58:00", "2024-05-04 00:00:00", "2024-05-04T00:02:00Z"}), 120.0);
  EXPECT_EQ(interval({"2024-02-28", "2024-02-29", "2024-03-01"}), 86400.0);
  EXPECT_EQ(interval({"03.05.2024 23:58", "04.05.2024 00:00", "04.05.2024 00:02"}), 120.0);
  EXPECT_EQ(interval({"5/3/2024 11:58:00 AM", "5/3/2024 12:00:00 PM", "5/3/2024 12:02:00 PM"}), 120.0);
  EXPECT_EQ(interval({"2024-05-03 10:05:00.25+02:00", "2024-05-03 10:05:01.50+02:00"}), 1.25);
  EXPECT_EQ(interval({"00:00", "00:02", "00:04"}, "time (h:min)"), 120.0);
  EXPECT_EQ(interval({"00:00", "00:02", "00:04"}, "time (mm:ss)"), 2.0);
}

TEST(TrackClock, WhatCanBeReadInTwoWaysIsAsked) {
  EXPECT_EQ(faults("track,time,x_um,y_um\n1,00:00,0,0\n1,00:02,1,0\n", few()),
            "f: time: times of two parts may be h:min or min:s: write all three, h:min:s");
  EXPECT_EQ(faults("track,time,x_um,y_um\n1,5/3/2024 10:00,0,0\n1,5/4/2024 10:00,1,0\n", few()),
            "f: time: dates with / may be read in two ways: write 2024-05-03");
  EXPECT_EQ(faults("track,time,x_um,y_um\n1,00:00:00,0,0\n1,00:02:0x,1,0\n1,00:04:00,1,0\n", few()),
            "f:3:1: time: \"00:02:0x\" is no time of the clock, as others are");
  EXPECT_EQ(faults("track,time,x_um,y_um\n1,23:58:00,0,0\n1,23:59:00,0,0\n1,00:00:00,1,0\n", few()),
            "f:4:1: time: times of the clock go over midnight: write them with the date");
}

} // namespace
} // namespace matrigrate::tracks
