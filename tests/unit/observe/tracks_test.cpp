#include "observe/tracks.hpp"

#include <gtest/gtest.h>

#include <utility>

using namespace matrigrate;

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
