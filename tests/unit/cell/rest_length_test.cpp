#include "cell/rest_length.hpp"

#include "ring.hpp"

using namespace matrigrate;

TEST(RestLength, FollowsAShorteningSegmentDownToItsInitialLength) {
  constexpr double initial = 0.4;
  struct Row {
    double l0, l, expected;
  };
  for (const Row& row : {Row{0.8, 0.6, 0.6},   // shortened: remembered
                         Row{0.8, 0.9, 0.8},   // stretched: springs back
                         Row{0.8, 0.8, 0.8},   //
                         Row{0.8, 0.4, 0.4},   // as far as the initial length
                         Row{0.8, 0.39, 0.8},  // not below it
                         Row{0.4, 0.39, 0.4},  // unstretched
                         Row{0.3, 0.35, 0.3}}) // shorter than initially, stretched
    EXPECT_EQ(ratcheted(row.l0, row.l, initial), row.expected) << row.l0 << " -> " << row.l;
}

TEST(RestLength, RatchetsAllSegmentsButTheSoftOnes) {
  const CellParameters p = small_cell();
  CortexState c = round_cortex(p);
  const double initial = initial_segment_length(p);
  for (Vec2& x : c.x) x *= 1.2;
  c.l0.assign(c.size(), 1.5 * initial);
  std::vector<std::uint8_t> soft(c.size(), 0);
  for (std::size_t i = 10; i < 20; ++i) soft[i] = 1;
  ratchet_rest_lengths(c, p, soft);
  for (std::size_t i = 0; i < c.size(); ++i) EXPECT_NEAR(c.l0[i], (soft[i] ? 1.5 : 1.2) * initial, 1e-12);
}

TEST(RestLength, OfTheUnstretchedCellStays) {
  const CellParameters p = small_cell();
  CortexState c = round_cortex(p);
  const std::vector<double> before = c.l0;
  for (const double scale : {0.7, 1.3}) {
    for (std::size_t i = 0; i < c.size(); ++i) c.x[i] *= scale;
    ratchet_rest_lengths(c, p, std::vector<std::uint8_t>(c.size(), 0));
    EXPECT_EQ(c.l0, before);
  }
}
