#include "study_report/beside.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include <unistd.h>

namespace matrigrate::study {
namespace {

/// Straight tracks of these speeds [um per interval], all of ten intervals of 60 s.
CellGroup straight(const std::string& label, const std::vector<double>& speeds) {
  CellGroup group{.label = label, .tracks = {}};
  group.tracks.interval = 60.0;
  for (const double speed : speeds) {
    tracks::Track& track = group.tracks.tracks.emplace_back();
    track.name = std::to_string(group.tracks.tracks.size());
    for (std::size_t k = 0; k <= 10; ++k) {
      track.k.push_back(k);
      track.x.push_back(speed * static_cast<double>(k));
      track.y.push_back(0.0);
    }
  }
  return group;
}

class Beside : public ::testing::Test {
protected:
  Beside() { std::filesystem::remove_all(folder); }
  ~Beside() override { std::filesystem::remove_all(folder); }
  std::filesystem::path folder = std::filesystem::temp_directory_path() / ("beside-" + std::to_string(::getpid()));
};

/// A run whose cell goes 1 um a minute along x for ten minutes, and ends between two rows.
void write_run(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_file(folder / "run.json", R"({"status":"done"})");
  std::string csv = "track,t_s,x_um,y_um\n";
  for (int k = 0; k <= 10; ++k) csv += "1," + std::to_string(60 * k) + "," + std::to_string(k) + ",0\n";
  write_file(folder / "tracks.csv", csv + "1,630,10.5,0\n");
}

TEST_F(Beside, SimulatedCellsAreSeenAtTheIntervalAndForTheDurationOfTheMeasuredOnes) {
  write_run(folder / "run");
  const auto cells = simulated_cells(folder / "run", {.interval = 120.0, .duration = 480.0, .error = 0.0});
  ASSERT_EQ(cells.size(), 1U);
  const tracks::Track& track = cells.front().tracks.tracks.at(0);
  EXPECT_EQ(track.x, (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0}));
  EXPECT_EQ(cells.front().tracks.interval, 120.0);
  EXPECT_TRUE(cells.front().tracks.notes.empty());
  const auto longer = simulated_cells(folder / "run", {.interval = 60.0, .duration = 1200.0, .error = 0.0});
  EXPECT_EQ(longer.front().tracks.tracks.at(0).x.size(), 11U) << "the last row comes half an interval late";
  EXPECT_EQ(longer.front().tracks.notes.at(0), "1 of 1 simulated paths are shorter than 20 min");
  write_file(folder / "run/run.json", R"({"status":"failed"})");
  EXPECT_THROW(simulated_cells(folder / "run", {.interval = 60.0, .duration = 480.0, .error = 0.0}),
               ConfigurationError);
  write_file(folder / "run/run.json", R"({"status":"done"})");
  EXPECT_THROW(simulated_cells(folder / "run", {.interval = 90.0, .duration = 480.0, .error = 0.0}),
               ConfigurationError);
}

TEST_F(Beside, TheErrorOfTheMicroscopeIsAddedToSimulatedCoordinatesOnly) {
  std::string csv = "track,t_s,x_um,y_um\n";
  for (int k = 0; k <= 4000; ++k) csv += "1," + std::to_string(60 * k) + ",0,0\n";
  std::filesystem::create_directories(folder / "run");
  write_file(folder / "run/tracks.csv", csv);
  write_file(folder / "run/run.json", R"({"status":"done"})");
  const auto cells = simulated_cells(folder / "run", {.interval = 60.0, .duration = 1e9, .error = 0.5});
  const tracks::Track& track = cells.front().tracks.tracks.at(0);
  double xx = 0.0, yy = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < track.x.size(); ++i) {
    xx += track.x[i] * track.x[i];
    yy += track.y[i] * track.y[i];
    xy += track.x[i] * track.y[i];
  }
  const auto n = static_cast<double>(track.x.size());
  EXPECT_NEAR(std::sqrt(xx / n), 0.5, 0.03) << "five standard errors";
  EXPECT_NEAR(std::sqrt(yy / n), 0.5, 0.03);
  EXPECT_NEAR(xy / n, 0.0, 0.02);
}

TEST_F(Beside, GroupsOfOtherIntervalsOrTheSamePositionsAreRefusedAtOnce) {
  CellGroup slow = straight("slow", {1.0, 2.0, 3.0});
  slow.tracks.interval = 120.0;
  const CellGroup control = straight("control", {1.0, 2.0, 3.0});
  try {
    require_comparable({control, control, slow});
    FAIL() << "they were taken";
  } catch (const ConfigurationError& error) {
    EXPECT_EQ(error.faults().size(), 5U) << "the same three times, another interval twice";
    EXPECT_EQ(error.faults().at(0).message, "has the same positions as control");
  }
  EXPECT_NO_THROW(require_comparable({control, straight("treated", {1.0, 2.0, 4.0})}));
}

TEST_F(Beside, ThePageHasMediansTestsAndCurvesOfTheGroups) {
  const std::vector<CellGroup> groups{straight("control", {1.0, 2.0, 3.0, 4.0, 5.0}),
                                      straight("model", {11.0, 12.0, 13.0, 14.0, 15.0})};
  EXPECT_EQ(usual_duration(groups), 600.0);
  tracks::Tracks shorter = groups[0].tracks;
  EXPECT_EQ(cut(shorter, 240.0), 4U);
  EXPECT_EQ(shorter.tracks[1].x, (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0}));
  const auto page = beside_data(groups, {.interval = 60.0, .duration = 600.0, .error = 0.0});
  EXPECT_EQ(page.at("axes").at(0).at("values").dump(), R"(["control","model"])");
  EXPECT_EQ(page.at("runs").size(), 10U);
  EXPECT_NEAR(page.at("runs").at(9).at("readouts").at("speed_um_per_h").get<double>(), 900.0, 1e-9);
  const auto& speeds = page.at("groups").at(0);
  EXPECT_NEAR(speeds.at("median").get<double>(), 180.0, 1e-9);
  EXPECT_GE(speeds.at("median_interval").at(0).get<double>(), 60.0);
  EXPECT_LT(speeds.at("median_interval").at(0).get<double>(), 180.0);
  const auto& test = page.at("tests").at(0);
  EXPECT_NEAR(test.at("p").get<double>(), 2.0 / 252.0, 1e-12) << "five values above five: 2 of 252 orders are as far";
  EXPECT_EQ(test.at("p_holm"), test.at("p"));
  EXPECT_NEAR(test.at("difference").get<double>(), 600.0, 1e-9);
  const auto& msd = page.at("msd").at(1);
  EXPECT_NEAR(msd.at("msd_um2").at(0).get<double>(), (121.0 + 144.0 + 169.0 + 196.0 + 225.0) / 5.0, 1e-9);
  EXPECT_NEAR(msd.at("slope").get<double>(), 2.0, 1e-9);
}

} // namespace
} // namespace matrigrate::study
