#include "unit/tracks/reading.hpp"

#include <gtest/gtest.h>

namespace matrigrate::tracks {
namespace {

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
            "(frameInterval): give --interval S, s from frame to frame, or --time-unit s if it is 1 s");
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
            "f: x and y are in pixel: give --pixel UM, um per pixel\n"
            "f: its times are numbers of frames (t): give --interval S, s from frame to frame");
  EXPECT_EQ(faults(text, few()), "f:11:1: is cut short: its last line is not \"End of MTrackJ Data File\"");
  EXPECT_EQ(faults("MTrackJ 1.5.1 Data File\nPoint 1 0 0 1 1 1\nTrack 1\nPoint 2 0 0\nPoint 3 a 0 1 1 1\n" + end),
            "f:2:1: has a point in no track\nf:4:1: has 4 words; Point ID x y z t are wanted\n"
            "f:5:1: x: \"a\" is no finite number");
}

TEST(TrackRows, EachFaultHasItsLine) {
  const std::string head = "track,t_s,x_um,y_um,dummy\n1,0,0,0,False\n";
  EXPECT_EQ(faults(head + "1,60,1_000,0,False\n1,120,1,0x1,False\n1,180,1,1,maybe\n1,240,1\n1,300,\"1,1,1\n", few()),
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
