#include "study_report/claim_figures.hpp"

#include "claims/shipped_studies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace matrigrate::study {
namespace {

TEST(ClaimFigures, FibresAreOfAPointThatTheStudyHas) {
  const auto shipped = std::ranges::find(read_shipped_studies(), fibre_study, &ReadStudy::name);
  ASSERT_NE(shipped, read_shipped_studies().end());
  EXPECT_EQ(std::ranges::count(shipped->study.points, fibre_point, &Point::label), 1);
}

} // namespace
} // namespace matrigrate::study
