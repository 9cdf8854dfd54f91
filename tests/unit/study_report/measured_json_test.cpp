#include "study_report/measured_json.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace matrigrate::study {
namespace {

using Json = nlohmann::ordered_json;

tracks::CellTrack straight(std::uint32_t cell, double x, std::size_t positions) {
  tracks::CellTrack track{.cell = cell, .t = {}, .x = {}, .y = {}};
  for (std::size_t i = 0; i < positions; ++i) {
    track.t.push_back(60.0 * static_cast<double>(i));
    track.x.push_back(x + static_cast<double>(i));
    track.y.push_back(5.0);
  }
  return track;
}

TEST(MeasuredJson, TracksBeginAtTheOriginWithNullBetweenThem) {
  EXPECT_EQ(measured_json({straight(1, 10.0, 3), straight(2, -4.0, 2)}).dump(),
            R"({"total":2,"t_s":[0.0,60.0,120.0,null,0.0,60.0],"x_um":[0.0,1.0,2.0,null,0.0,1.0],)"
            R"("y_um":[0.0,0.0,0.0,null,0.0,0.0]})");
  EXPECT_TRUE(measured_json(std::vector<tracks::CellTrack>()).is_null());
}

TEST(MeasuredJson, ManyAreThinnedEvenly) {
  std::vector<tracks::CellTrack> many;
  for (int k = 0; k < 401; ++k) many.push_back(straight(k, 0.0, 1000));
  const Json json = measured_json(many);
  EXPECT_EQ(json.at("total"), 401);
  const Json& t = json.at("t_s");
  EXPECT_EQ(t.size(), 200U * 100U + 199U);
  EXPECT_EQ(t.at(99), 60.0 * 999) << "the last position of a track is kept";
}

TEST(MeasuredJson, TargetsTellWhichPointsTheyBelongTo) {
  Study study;
  study.conditions = {{"soft", {}}, {"stiff", {}}};
  study.points.resize(2);
  study.points[1].condition = 1;
  const auto soft = std::make_shared<const std::vector<tracks::CellTrack>>(2, straight(1, 0.0, 2));
  const auto both = std::make_shared<const std::vector<tracks::CellTrack>>(3, straight(1, 0.0, 2));
  study.targets = {{.readout = "a", .at = {0}, .tracks = soft},
                   {.readout = "b", .at = {0}, .tracks = soft},
                   {.readout = "c", .at = {}, .tracks = both},
                   {.readout = "d", .at = {}}};
  const Json list = measured_json(study, {straight(1, 0.0, 2)}, {Json{0}, Json{1}});
  ASSERT_EQ(list.size(), 3U) << "a file that two targets name counts once";
  EXPECT_EQ(list.at(0).at("points").dump(), "[[0],[1]]") << "those of the command line belong to all points";
  EXPECT_EQ(list.at(1).at("points").dump(), "[[0]]");
  EXPECT_EQ(list.at(2).at("points").dump(), "[[0],[1]]");
  EXPECT_EQ(tracks_at(study, {}, 0).size(), 5U);
  EXPECT_EQ(tracks_at(study, {}, 1).size(), 3U);
}

} // namespace
} // namespace matrigrate::study
