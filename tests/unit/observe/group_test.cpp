#include "observe/group.hpp"

#include "state/cortex.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace matrigrate;

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
