#include "store/trajectory_hash.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace matrigrate::store {
namespace {

State state() {
  State s;
  s.cells.emplace_back().cortex.x = {{1, 2}, {3, 4}};
  s.ecm.x = {{5, 6}, {7, 8}, {9, 10}};
  return s;
}

std::string hash(const State& s) {
  TrajectoryHash h;
  h.add(s);
  return h.text();
}

TEST(TrajectoryHash, SeesEveryBit) {
  const std::string reference = hash(state());
  EXPECT_EQ(reference.size(), 16U);
  EXPECT_EQ(hash(state()), reference);
  State s = state();
  s.ecm.x[2].y() = std::nextafter(10.0, 11.0);
  EXPECT_NE(hash(s), reference);
  s = state();
  s.cells[0].cortex.x[0].x() = std::nextafter(1.0, 0.0);
  EXPECT_NE(hash(s), reference);
  s = state();
  ++s.step;
  EXPECT_NE(hash(s), reference);
}

TEST(TrajectoryHash, SeesEveryCell) {
  State s = state();
  s.cells.push_back(s.cells[0]);
  EXPECT_NE(hash(s), hash(state()));
  const std::string both = hash(s);
  s.cells[1].cortex.x[1].y() = 5.0;
  EXPECT_NE(hash(s), both);
}

TEST(TrajectoryHash, SeesEveryNucleus) {
  State s = state();
  s.cells[0].nucleus.x = {{1, 1}, {2, 2}};
  const std::string with = hash(s);
  EXPECT_NE(with, hash(state()));
  s.cells[0].nucleus.x[1].x() = std::nextafter(2.0, 3.0);
  EXPECT_NE(hash(s), with);
}

TEST(TrajectoryHash, GoesOn) {
  TrajectoryHash h;
  h.add(state());
  const std::string one = h.text();
  EXPECT_EQ(h.text(), one) << "telling it does not change it";
  h.add(state());
  EXPECT_NE(h.text(), one);
}

TEST(TextHash, IsThatOfXxHash) { EXPECT_EQ(text_hash(""), "2d06800538d394c2"); } // XXH3_64bits of nothing

} // namespace
} // namespace matrigrate::store
