#include "run/cadence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace matrigrate::run {
namespace {

TEST(Cadence, IsDueOnceAtEachMultipleHoweverTimesAreRounded) {
  const double below = std::nextafter(0.3, 0.0);
  const double above = std::nextafter(0.3, 1.0);
  for (const double t : {below, 0.3, above}) {
    Cadence cadence(0.3, 0.1);
    EXPECT_TRUE(cadence.due(0.0));
    EXPECT_FALSE(cadence.due(0.1));
    EXPECT_FALSE(cadence.due(0.2));
    EXPECT_TRUE(cadence.due(t));
    EXPECT_FALSE(cadence.due(t)) << t;
    EXPECT_FALSE(cadence.due(0.4)) << t;
    EXPECT_TRUE(cadence.due(0.6));
  }
}

TEST(Cadence, IsDueOnceAfterALongStepAndThenAtMultiplesAgain) {
  Cadence cadence(2.0, 1.0);
  EXPECT_TRUE(cadence.due(0.0));
  EXPECT_TRUE(cadence.due(7.0)); // those at 2, 4 and 6 are past
  EXPECT_FALSE(cadence.due(7.5));
  EXPECT_TRUE(cadence.due(8.0));
}

TEST(Cadence, OfNoIntervalIsNeverDue) {
  Cadence cadence(0.0, 1.0);
  EXPECT_FALSE(cadence.due(0.0));
  EXPECT_FALSE(cadence.due(100.0));
}

} // namespace
} // namespace matrigrate::run
