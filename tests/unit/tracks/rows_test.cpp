#include "unit/tracks/reading.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

/// Lines of a table that are rows, and those that are none.
namespace matrigrate::tracks {
namespace {

const std::string plain_head = "track,t_s,x_um,y_um\n";

/// Rows of a track that goes 1 um a minute along x.
std::string rows(const std::string& id, int n, double y = 0.0) {
  std::string text;
  for (int k = 0; k < n; ++k) text += fmt::format("{},{},{},{}\n", id, 60 * k, k, y);
  return text;
}

TEST(TrackComments, AnIdMayBeginAsOne) {
  for (const char* sign : {"#", "%", "//", ";"}) {
    EXPECT_EQ(of_text(plain_head + rows(sign + std::string("1"), 3) + rows("\"" + std::string(sign) + "2\"", 3), few())
                  .positions(),
              6U)
        << sign;
    const std::string comment = sign + std::string(" by hand, twice, with care, in May\n");
    const Tracks cells = of_text(plain_head + rows("1", 3) + comment + rows(sign + std::string("2"), 3), few());
    EXPECT_EQ(cells.positions(), 6U) << sign;
    EXPECT_TRUE(notes(cells, "1 comment within the table is left out (line 5)")) << sign;
  }
  EXPECT_TRUE(notes(of_text(plain_head + "# a\n#b,c,d,e\n# f\n#g\n" + rows("1", 3), few()),
                    "4 comments within the table are left out (lines 2, 3, 4 ...)"));
  EXPECT_EQ(of_text("% track_id\tt_s\tx_um\ty_um\n#1\t0\t0\t0\n#1\t60\t1\tNaN\n#1\t120\t2\t0\n", few()).positions(),
            2U);
  EXPECT_EQ(of_text("# track t_s x_um y_um\n1 0 0 0\n1 60 1 1\n", few()).positions(), 2U);
}

TEST(TrackIds, ThatMeanNoTrack) {
  const Tracks cells = of_text(plain_head + rows("-1", 2) + rows("1", 3) + rows("0", 3) + rows("-2.0", 1), few());
  EXPECT_EQ(cells.tracks.size(), 2U) << "0 is an id";
  EXPECT_TRUE(notes(cells, "3 positions in no track (id -1, -2) are left out"));
  for (const char* id : {"", "NaN", "none", "NULL",
                         "\"\u2212"
                         "1\"",
                         "-1.00", "<NA>"})
    EXPECT_EQ(of_text(plain_head + rows(id, 3) + rows("1", 3), few()).tracks.size(), 1U) << id;
  EXPECT_EQ(of_text(plain_head + rows("-a", 3), few()).tracks.size(), 1U) << "no number";
}

TEST(TrackIds, ObjectsOfIlastik) {
  TrackOptions options = few(calibrated(1.0, 60.0));
  for (const char* place : {"Center_of_the_object", "Object_Center", "Center of the object"}) {
    const Tracks cells = of_text(fmt::format("frame,labelimageId,trackId,lineageId,{0}_0,{0}_1\n0,1,2,2,0,0\n0,2,-1,-1,"
                                             "7,7\n1,1,2,2,3,4\n1,2,-1,-1,90,90\n",
                                             place),
                                 options);
    EXPECT_EQ(cells.layout, "ilastik");
    EXPECT_EQ(speed(cells), 300.0) << place;
  }
}

TEST(TrackHeaders, InTheMiddleAreNoRows) {
  const Tracks cells =
      of_text("movie," + plain_head + "a,1,0,0,0\na,1,60,1,0\nmovie," + plain_head + "b,1,0,5,5\nb,1,60,6,5\n", few());
  EXPECT_EQ(cells.tracks.size(), 2U);
  EXPECT_TRUE(notes(cells, "line 4 repeats the header: 2 files were joined"));
  const std::string trackmate = "TRACK_ID,POSITION_X,POSITION_Y,FRAME\nTrack ID,X,Y,Frame\n,(um),(um),\n";
  EXPECT_EQ(of_text(trackmate + "1,0,0,0\n1,1,1,1\n" + trackmate + "2,0,0,0\n2,1,1,1\n", few(calibrated(1.0, 60.0)))
                .positions(),
            4U);
}

TEST(TrackFooters, AreLeftOut) {
  const Tracks cells = of_text(plain_head + rows("1", 3) + "Mean,,1.0,0\nSD,,0.8,0\nexported in May\n", few());
  EXPECT_EQ(cells.positions(), 3U);
  EXPECT_TRUE(notes(cells, "3 lines below the table are left out (lines 5, 6, 7)"));
  EXPECT_EQ(faults(plain_head + rows("1", 3) + "1,240,1\n", few()), "f:5:1: has 3 fields, the header 4") << "cut short";
  EXPECT_EQ(faults(plain_head + rows("a", 3) + "a,240\n", few()), "f:5:1: has 2 fields, the header 4");
}

TEST(TrackFaults, OfOneKindAreCounted) {
  std::string text = plain_head;
  for (int k = 0; k < 600; ++k) text += fmt::format("{},0,\"?{}\",0\n", k, k);
  EXPECT_EQ(faults(text), "f:2:1: x_um: \"?0\" is no finite number (and 599 more)");
}

} // namespace
} // namespace matrigrate::tracks
