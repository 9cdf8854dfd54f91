#include "base/random.hpp"
#include "observe/readouts.hpp"
#include "observe/tracks.hpp"
#include "state/cortex.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

using namespace matrigrate;

namespace {

/// Rows every 60 s that follow a path.
template <class Path>
std::vector<TrackRow> walk(int n, const Path& path) {
  std::vector<TrackRow> rows(static_cast<std::size_t>(n) + 1);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].t = 60.0 * static_cast<double>(k);
    rows[k].centre = path(static_cast<double>(k));
  }
  return rows;
}

} // namespace

TEST(Msd, OfAStraightPathGrowsAsTheSquareOfTheLag) {
  const auto rows = walk(360, [](double k) { return Vec2(0.3 * k, -0.4 * k); });
  const std::vector<MsdPoint> points = mean_square_displacement(rows, 600.0);
  ASSERT_EQ(points.size(), 18U); // up to half of six hours
  EXPECT_DOUBLE_EQ(points[0].lag, 600.0);
  EXPECT_NEAR(points[0].msd, 25.0, 1e-9);
  EXPECT_EQ(points[0].samples, 36U);
  EXPECT_NEAR(points[3].msd, 400.0, 1e-9);
  EXPECT_NEAR(msd_slope(points), 2.0, 1e-12);
}

TEST(Msd, OfARandomWalkGrowsInProportionToTheLag) {
  double slope = 0.0;
  constexpr int walks = 200;
  for (std::uint64_t seed = 1; seed <= walks; ++seed) {
    Vec2 x = Vec2::Zero();
    const auto rows = walk(360, [&](double k) {
      const double a = 2.0 * std::numbers::pi * uniform(seed, Purpose::test, static_cast<std::uint64_t>(k), 0);
      x += Vec2(std::cos(a), std::sin(a));
      return x;
    });
    slope += msd_slope(mean_square_displacement(rows, 60.0)) / walks;
  }
  EXPECT_NEAR(slope, 1.0, 0.1);
}

TEST(Msd, HasTheBitsOfSumsByTime) {
  const auto rows = walk(41, [](double k) { return Vec2(7.3 * std::sin(1.7 * k * k), 0.31 * k + std::cos(k)); });
  const std::vector<MsdPoint> points = mean_square_displacement(rows, 60.0);
  ASSERT_EQ(points.size(), 20U);
  for (std::size_t lag = 1; lag <= points.size(); ++lag) {
    double sum = 0.0;
    for (std::size_t k = 0; k + lag < rows.size(); ++k) sum += (rows[k + lag].centre - rows[k].centre).squaredNorm();
    EXPECT_EQ(points[lag - 1].msd, sum / static_cast<double>(rows.size() - lag)) << lag;
  }
}

TEST(Msd, NeedsRowsAtMultiplesOfTheInterval) {
  const auto rows = walk(20, [](double k) { return Vec2(k, 0.0); });
  EXPECT_TRUE(mean_square_displacement(rows, 90.0).empty());
  EXPECT_TRUE(mean_square_displacement({}, 60.0).empty());
  EXPECT_TRUE(std::isnan(msd_slope({})));
  EXPECT_EQ(mean_square_displacement(rows, 120.0).size(), 5U);
}

TEST(Guidance, AnglesAreZeroAlongAndNinetyAcrossWithoutSign) {
  const auto rows = walk(40, [](double k) { return Vec2(k, 0.0); });
  const auto angles = [&](double direction, double wanted) {
    const Guidance g = guidance(rows, direction, 60.0);
    for (const double angle : {g.path_angle, g.step_angle, g.net_angle}) EXPECT_NEAR(angle, wanted, 1e-9);
  };
  angles(0.0, 0.0);
  angles(std::numbers::pi, 0.0);
  angles(0.5 * std::numbers::pi, 90.0);
  angles(-0.25 * std::numbers::pi, 45.0);
  const auto circle = walk(400, [](double k) { return Vec2(std::cos(0.01571 * k), std::sin(0.01571 * k)); });
  EXPECT_NEAR(guidance(circle, 0.3, 60.0).path_angle, 45.0, 0.5);
  const Guidance still = guidance(walk(40, [](double) { return Vec2(1.0, 1.0); }), 0.0, 60.0);
  for (const double angle : {still.path_angle, still.step_angle, still.net_angle}) EXPECT_TRUE(std::isnan(angle));
}

TEST(Guidance, WeighsStepsByTheirLengthOrNot) {
  const auto rows = walk(4, [](double k) { return Vec2(3.0 * std::ceil(0.5 * k), std::floor(0.5 * k)); });
  const Guidance g = guidance(rows, 0.0, 60.0); // three along, one across, and again
  EXPECT_NEAR(g.path_angle, 22.5, 1e-9);
  EXPECT_NEAR(g.step_angle, 45.0, 1e-9);
  EXPECT_NEAR(g.net_angle, std::atan2(2.0, 6.0) * 180.0 / std::numbers::pi, 1e-9);
}

TEST(Guidance, ToAndFroAlongTheFibresIsNotFollowingThem) {
  // 8 um along the fibres and back in two hours, and 1 um across in an hour, for six hours
  const auto rows = walk(360, [](double k) { return Vec2(8.0 * std::abs(std::remainder(k / 60.0, 2.0)), k / 60.0); });
  const Guidance g = guidance(rows, 0.0, 600.0);
  EXPECT_LT(g.path_angle, 8.0);
  EXPECT_GT(g.ratios[0], 20.0);
  EXPECT_GT(g.ratios[1], 2.0);
  EXPECT_NEAR(g.ratios[2], 0.0, 1e-12);
  EXPECT_NEAR(g.net_angle, 90.0, 1e-9);
  EXPECT_NEAR(guidance(rows, 0.5 * std::numbers::pi, 600.0).ratios[0], 1.0 / g.ratios[0], 1e-12);
}

TEST(Guidance, HasNoRatioAtALagThatIsLongerThanThePath) {
  const auto rows = walk(200, [](double k) { return Vec2(k, 2.0 * k); });
  const Guidance g = guidance(rows, 0.0, 600.0);
  EXPECT_NEAR(g.ratios[0], 0.25, 1e-12);
  EXPECT_NEAR(g.ratios[1], 0.25, 1e-12);
  EXPECT_TRUE(std::isnan(g.ratios[2]));
}

namespace matrigrate::observe {
namespace {

TEST(EvenTimes, AreToldFromUnevenOnes) {
  const std::vector<double> even{0, 5, 10.0000001, 15};
  EXPECT_TRUE(even_times(even).is_even());
  EXPECT_EQ(even_times(even).interval, 5.0);
  EXPECT_EQ(even_times(even).text(), "every 5 s");
  const std::vector<double> uneven{0, 7.5, 15, 21.25, 30, 35};
  EXPECT_EQ(even_times(uneven).even, 3U);
  EXPECT_FALSE(even_times(uneven).but_the_last());
  EXPECT_EQ(even_times(uneven).text(), "unevenly spaced, 5 to 8.75 s apart");
  const std::vector<double> again{0, 10, 25, 30, 40}; // later ones fit again
  EXPECT_EQ(even_times(again).even, 2U);
}

TEST(EvenTimes, MayHaveALastOneThatComesTooSoon) {
  const std::vector<double> ended{0, 70, 140, 180}, late{0, 5, 10, 17.5}, two{0, 180};
  EXPECT_FALSE(even_times(ended).is_even());
  EXPECT_TRUE(even_times(ended).but_the_last());
  EXPECT_FALSE(even_times(late).but_the_last());
  EXPECT_TRUE(even_times(two).is_even());
  EXPECT_TRUE(even_times(std::vector<double>{}).is_even());
}

TEST(EvenTimes, OfRowsAreThoseOfAllCellsTogether) {
  const std::vector<TrackRow> rows{{.t = 0.0, .polarization = {}},
                                   {.t = 0.0, .cell = 1, .polarization = {}},
                                   {.t = 60.0, .polarization = {}},
                                   {.t = 60.0, .cell = 1, .polarization = {}}};
  EXPECT_EQ(times_of(rows), (std::vector<double>{0, 60}));
}

} // namespace
} // namespace matrigrate::observe

namespace {

State cells_at(const Parameters& p, double t, const std::vector<CellStart>& starts) {
  State s;
  s.t = t;
  for (const CellStart& start : starts) {
    Cell& cell = s.cells.emplace_back();
    cell.id = static_cast<std::uint32_t>(s.cells.size()) - 1;
    cell.cortex = round_cortex(p.cell, start);
  }
  return s;
}

} // namespace

TEST(Group, TellsWhereItIsAndHowFarItReaches) {
  const Parameters p;
  const GroupRow row = group_row(cells_at(p, 60.0, {{0, 0}, {40, 0}, {100, 0}}), {}, p);
  EXPECT_EQ(row.t, 60.0);
  EXPECT_NEAR(row.centre.x(), 140.0 / 3.0, 1e-9);
  EXPECT_NEAR(row.spread,
              std::sqrt((std::pow(140.0 / 3.0, 2) + std::pow(20.0 / 3.0, 2) + std::pow(160.0 / 3.0, 2)) / 3.0), 1e-9);
  EXPECT_NEAR(row.nearest, (40.0 + 40.0 + 60.0) / 3.0, 1e-9);
  EXPECT_EQ(row.contacts, 0U);
  EXPECT_TRUE(std::isnan(row.gap));
  EXPECT_TRUE(std::isnan(row.speed)) << "nothing is known of earlier times";
}

TEST(Group, CountsPairsThatFeelEachOther) {
  Parameters p;
  const State s = cells_at(p, 60.0, {{0, 0}, {30.5, 0}, {0, 30.7}, {60, 60}});
  const GroupRow row = group_row(s, {}, p);
  EXPECT_EQ(row.contacts, 2U);
  EXPECT_NEAR(row.gap, 0.5, 0.01);
  p.contact.cells.repulsion_range = 0.6;
  EXPECT_EQ(group_row(s, {}, p).contacts, 1U);
}

TEST(Group, MovesAsItsCellsDo) {
  const Parameters p;
  const std::vector<CellStart> starts{{0, 0}, {60, 0}};
  std::vector<TrackRow> rows;
  for (const double t : {0.0, 300.0, 600.0})
    for (const TrackRow& row : track_rows(cells_at(p, t, starts))) rows.push_back(row);
  const GroupRow together = group_row(cells_at(p, 900.0, {{3, 0}, {63, 0}}), rows, p);
  EXPECT_NEAR(together.speed, 3.0 * 6.0, 1e-9) << "since t = 300 s";
  EXPECT_NEAR(together.order, 1.0, 1e-9);
  EXPECT_NEAR(together.direction, 0.0, 1e-9);
  const GroupRow apart = group_row(cells_at(p, 900.0, {{-3, 0}, {63, 0}}), rows, p);
  EXPECT_NEAR(apart.order, 0.0, 1e-9);
  const GroupRow across = group_row(cells_at(p, 900.0, {{3, 0}, {60, 5}}), rows, p);
  EXPECT_NEAR(across.order, std::numbers::sqrt2 / 2.0, 1e-9);
  EXPECT_NEAR(across.direction, 0.25 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(across.speed, 4.0 * 6.0, 1e-9);
}

namespace {

Protrusion living(std::uint32_t id, Phase phase) {
  Protrusion protrusion;
  protrusion.phase = std::move(phase);
  protrusion.record.id = id;
  return protrusion;
}

} // namespace

TEST(TrackRow, TellsPlaceAndShapeOfASquare) {
  Cell cell;
  cell.cortex.x = {{3, 5}, {7, 5}, {7, 9}, {3, 9}};
  cell.polarization = 0.5;
  const TrackRow row = track_row(cell, {.step = 10, .t = 4.0});
  EXPECT_EQ(row.t, 4.0);
  EXPECT_EQ(row.step, 10U);
  EXPECT_NEAR((row.centre - Vec2(5, 7)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(row.area, 16.0, 1e-12);
  EXPECT_NEAR(row.perimeter, 16.0, 1e-12);
  EXPECT_EQ(row.polarization, 0.5);
  EXPECT_EQ(row.alive(), 0U);
}

TEST(TrackRow, CountsProtrusionsByPhase) {
  Cell cell;
  cell.cortex.x = {{0, 0}, {1, 0}, {0, 1}};
  cell.initiated = 7;
  cell.protrusions = {living(4, Contracting{Vec2::Zero(), 0.5}), living(6, Growing{Vec2::UnitX()}),
                      living(7, Contracting{Vec2::Zero(), 0.5})};
  const TrackRow row = track_row(cell, {});
  EXPECT_EQ(row.in_phase, (std::array<std::uint32_t, 4>{1, 0, 2, 0}));
  EXPECT_EQ(row.alive(), 3U);
  EXPECT_EQ(row.initiated, 7U);
  EXPECT_FALSE(row.polarization);
}

TEST(TrackRow, TellsOfANucleusWhereThereIsOne) {
  Cell cell;
  cell.cortex.x = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
  EXPECT_FALSE(track_row(cell, {}).nucleus);
  cell.nucleus.x = {{1, 1}, {5, 1}, {5, 3}, {1, 3}};
  const TrackRow row = track_row(cell, {});
  ASSERT_TRUE(row.nucleus);
  EXPECT_NEAR((row.nucleus->centre - Vec2(3, 2)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(row.nucleus->area, 8.0, 1e-12);
  EXPECT_NEAR(row.nucleus->aspect, 2.0, 1e-12);
}

TEST(TrackRows, AreThoseOfAllCells) {
  State s;
  s.t = 60.0;
  s.cells.resize(2);
  s.cells[0].cortex.x = {{0, 0}, {1, 0}, {0, 1}};
  s.cells[1].cortex.x = {{3, 3}, {4, 3}, {3, 4}};
  s.cells[1].id = 7;
  std::vector<TrackRow> rows = track_rows(s);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].cell, 7U);
  EXPECT_EQ(number_of(rows[1].cell), 8U);
  s.t = 120.0;
  for (const TrackRow& row : track_rows(s)) rows.push_back(row);
  const std::vector<TrackRow> second = rows_of(rows, 7);
  ASSERT_EQ(second.size(), 2U);
  EXPECT_EQ(second[1].t, 120.0);
  EXPECT_GT(second[0].centre.x(), 3.0);
}

TEST(ProtrusionRecords, AreInTheOrderOfInitiation) {
  Cell cell;
  cell.protrusions = {living(2, Finishing{0.05}), living(4, Finishing{0.05})};
  for (const std::uint32_t id : {3U, 1U}) {
    ProtrusionRecord r;
    r.id = id;
    cell.ended.push_back(r);
  }
  const auto records = protrusion_records(cell);
  ASSERT_EQ(records.size(), 4U);
  for (std::uint32_t k = 0; k < 4; ++k) EXPECT_EQ(records[k].id, k + 1);
}
