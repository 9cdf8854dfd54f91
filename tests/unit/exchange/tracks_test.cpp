#include "exchange/run_tracks.hpp"
#include "unit/draw/markup.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>
#include <vector>

namespace matrigrate::exchange {
namespace {

TrackRow row(double t, std::uint32_t cell, const Vec2& centre) {
  return {.t = t, .cell = cell, .centre = centre, .area = 3.141592653589793, .polarization = {}};
}

/// A run of two cells, and one of one cell that ended early.
std::vector<RunTracks> two_runs() {
  return {
      {.name = "aa",
       .condition = "soft, or so",
       .replicate = 1,
       .seed = 7,
       .rows = {row(0, 0, {1, 2}), row(0, 1, {3, 4}), row(60, 0, {1.5, 2}), row(60, 1, {3, 4.5}), row(120, 0, {2, 2}),
                row(120, 1, {3, 5})},
       .settings = {{"ecm.youngs_modulus", "\"50 Pa\""}}},
      {.name = "bb", .condition = "stiff", .replicate = 2, .seed = 8, .rows = {row(0, 0, {0, 0}), row(60, 0, {9, 9})}}};
}

TEST(RunTracks, AreTakenAtExactlyTheTimesAskedFor) {
  const std::vector<RunTracks> runs = two_runs();
  const auto times = [](const std::vector<TrackRow>& rows) {
    std::vector<double> t;
    for (const TrackRow& r : rows) t.push_back(r.t);
    return t;
  };
  EXPECT_EQ(times(rows_at(runs[0], {})), (std::vector<double>{0, 0, 60, 60, 120, 120}));
  EXPECT_EQ(times(rows_at(runs[0], {.every = 120.0, .list = {}})), (std::vector<double>{0, 0, 120, 120}));
  EXPECT_EQ(times(rows_at(runs[0], {.every = {}, .list = {60.0}})), (std::vector<double>{60, 60}));
  EXPECT_EQ(times(rows_at(runs[1], {.every = 60.0, .list = {}})), (std::vector<double>{0, 60}));
}

TEST(RunTracks, NameAllTimesThatARunLacks) {
  const std::vector<RunTracks> runs = two_runs();
  const auto fault = [&](const RunTracks& run, const Times& times) -> std::string {
    try {
      rows_at(run, times);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(fault(runs[0], {.every = {}, .list = {30.0, 60.0, 500.0}}),
            "aa has no position at 30 s, 500 s: it has them every 60 s from 0 to 120 s, and none is interpolated; "
            "output.track_interval sets that interval");
  EXPECT_NE(fault(runs[0], {.every = 70.0, .list = {}}).find("aa has no position at 70 s: it has them every 60 s"),
            std::string::npos);
  EXPECT_EQ(fault(runs[0], {.every = 1e-9, .list = {}}),
            "every 1e-09 s is less than the time between two positions; aa has positions every 60 s, for 120 s");
  EXPECT_EQ(fault(runs[0], {.every = 3.6e12, .list = {}}),
            "every 3.6e+12 s is longer than the run; aa has positions every 60 s, for 120 s");
  const RunTracks uneven{
      .name = "dd", .condition = {}, .rows = {row(0, 0, {0, 0}), row(5, 0, {1, 0}), row(12, 0, {2, 0})}};
  EXPECT_NE(fault(uneven, {.every = {}, .list = {10.0}})
                .find("dd has no position at 10 s: it has them unevenly spaced, 5 to 7 s apart from 0 to 12 s"),
            std::string::npos);
  EXPECT_EQ(fault({.name = "cc", .condition = {}, .rows = {}}, {.every = {}, .list = {1.0}}),
            "cc has too few positions");
}

TEST(RunTracks, HaveATrackForEachCellOfEachRun) {
  const std::vector<RunTracks> runs = two_runs();
  const std::string spots = spots_csv(runs);
  EXPECT_EQ(spots.substr(0, spots.find('\n')),
            "Unique_ID,Condition,experiment_nb,Repeat,File_name,LABEL,ID,TRACK_ID,"
            "POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,FRAME,RADIUS,SPACE_UNIT,TIME_UNIT");
  EXPECT_NE(spots.find("\naa_1,\"soft, or so\",1,1,aa,cell 2,4,1,3,4.5,0,60,1,1,um,s\n"), std::string::npos);
  EXPECT_NE(spots.find("\nbb_2,stiff,2,2,bb,cell 1,7,2,9,9,0,60,1,1,um,s\n"), std::string::npos);
  EXPECT_EQ(tracks_csv(runs).substr(tracks_csv(runs).find("bb")), "bb_2,stiff,2,2,bb,cell 1,2,2,0,60\n");
}

TEST(RunTracks, CountNoFramesOfUnevenRows) {
  std::vector<RunTracks> runs = two_runs();
  runs[0].rows.push_back(row(130, 0, {2, 3}));
  const std::string spots = spots_csv(runs);
  EXPECT_EQ(spots.substr(0, spots.find('\n')),
            "Unique_ID,Condition,experiment_nb,Repeat,File_name,LABEL,ID,TRACK_ID,"
            "POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,RADIUS,SPACE_UNIT,TIME_UNIT");
  EXPECT_NE(spots.find("\naa_0,\"soft, or so\",1,1,aa,cell 1,3,0,2,3,0,130,1,um,s\n"), std::string::npos) << spots;
}

TEST(OpenVt, HasTheColumnsOfItsPortal) {
  const std::string text = openvt_csv(two_runs());
  EXPECT_TRUE(text.starts_with("simID,time,cellID,cellType,x,y\n0,0,1,0,1,2\n0,0,2,0,3,4\n0,60,1,0,1.5,2\n"));
  EXPECT_TRUE(text.ends_with("\n1,60,1,0,9,9\n"));
}

TEST(OpenVt, RecordsWhatWasSimulated) {
  Parameters base;
  base.ecm.radius = 80.0;
  base.cells = {{-20.0, 0.0}, {20.0, 0.0}};
  const auto record = nlohmann::json::parse(
      openvt_record({.title = "A \xff title", .version = "1.2", .updated = "2026-01-31", .base = base}, two_runs()));
  for (const auto& key : record.at("required")) EXPECT_TRUE(record.at("properties").contains(key)) << key;
  const auto& properties = record.at("properties");
  EXPECT_EQ(properties.at("parameters").at("ecm.radius"), "80 um");
  EXPECT_TRUE(properties.at("parameters").contains("cells"));
  EXPECT_EQ(properties.at("parameters").size(), 2U);
  EXPECT_TRUE(properties.at("input_files").is_array());
  ASSERT_EQ(properties.at("simulations").size(), 2U);
  EXPECT_EQ(properties.at("simulations")[0].at("parameters").at("ecm.youngs_modulus"), "50 Pa");
  EXPECT_EQ(properties.at("simulations")[1].at("simID"), 1);
  EXPECT_EQ(properties.at("simulations")[1].at("seed"), 8);
  const auto simulator = nlohmann::json::parse(openvt_simulator("1.2"));
  for (const char* key : {"name", "category", "description"}) EXPECT_TRUE(simulator.at(key).is_string()) << key;
  for (const auto& object : simulator.at("objects"))
    for (const char* key : {"attributes", "processes"}) EXPECT_TRUE(object.at(key).is_array()) << object;
  for (const auto& inside : simulator.at("containment")) EXPECT_TRUE(inside.at("inner_object_id").is_string());
}

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
