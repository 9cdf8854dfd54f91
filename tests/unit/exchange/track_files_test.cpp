#include "exchange/track_files.hpp"

#include "unit/draw/markup.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace matrigrate::exchange {
namespace {

TEST(TrackFiles, HoldThePath) {
  const std::vector<TrackRow> rows{{.t = 0.0, .centre = {1.5, -2.0}, .area = 3.141592653589793, .polarization = {}},
                                   {.t = 60.0, .centre = {2.5, 0.25}, .polarization = {}},
                                   {.t = 120.0, .centre = {3.5, 0.5}, .polarization = {}}};
  EXPECT_EQ(celltrackr_csv(rows), "id,t_s,x_um,y_um\n1,0,1.5,-2\n1,60,2.5,0.25\n1,120,3.5,0.5\n");
  EXPECT_EQ(occurrences(trackmate_csv(rows), "0,0,1.5,-2,0,0,0,1\n"), 1U);
  const std::string xml = trackmate_xml(rows);
  EXPECT_EQ(occurrences(xml, "frameInterval=\"60\""), 1U);
  EXPECT_EQ(occurrences(xml, "<detection t=\"1\" x=\"2.5\" y=\"0.25\" z=\"0\" />"), 1U);
  EXPECT_EQ(occurrences(celltrackr_csv({}), "\n"), 1U);
}

TEST(TrackFiles, CountNoFramesOfUnevenRows) {
  const std::vector<TrackRow> rows{{.t = 0.0, .centre = {1, 2}, .polarization = {}},
                                   {.t = 7.5, .centre = {3, 4}, .polarization = {}},
                                   {.t = 12.5, .centre = {5, 6}, .area = 3.141592653589793, .polarization = {}}};
  EXPECT_THROW(trackmate_xml(rows), std::invalid_argument);
  EXPECT_TRUE(trackmate_csv(rows).starts_with("ID,TRACK_ID,POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,RADIUS\n"
                                              "Spot ID,Track ID,X,Y,Z,T,Radius\nSpot ID,Track ID,X,Y,Z,T,R\n"
                                              ",,(micron),(micron),(micron),(sec),(micron)\n"));
  EXPECT_TRUE(trackmate_csv(rows).ends_with("\n2,0,5,6,0,12.5,1\n"));
}

TEST(TrackFiles, HaveATrackForEachCell) {
  const std::vector<TrackRow> rows{{.t = 0.0, .centre = {1, 2}, .polarization = {}},
                                   {.t = 0.0, .cell = 1, .centre = {3, 4}, .polarization = {}},
                                   {.t = 60.0, .centre = {5, 6}, .polarization = {}},
                                   {.t = 60.0, .cell = 1, .centre = {7, 8}, .polarization = {}}};
  EXPECT_EQ(celltrackr_csv(rows), "id,t_s,x_um,y_um\n1,0,1,2\n2,0,3,4\n1,60,5,6\n2,60,7,8\n");
  EXPECT_EQ(occurrences(trackmate_csv(rows), "3,1,7,8,0,60,1,0\n"), 1U);
  const std::string xml = trackmate_xml(rows);
  EXPECT_EQ(occurrences(xml, "nTracks=\"2\""), 1U);
  EXPECT_EQ(occurrences(xml, "<particle nSpots=\"2\">"), 2U);
  EXPECT_EQ(occurrences(xml, "<detection t=\"1\" x=\"7\" y=\"8\" z=\"0\" />"), 1U);
}

} // namespace
} // namespace matrigrate::exchange
