#include "claims/fields_shown.hpp"

#include "base/failure.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace matrigrate::study {
namespace {

/// Two particles of solid and one of fluid, each 300 s.
observe::Film film(std::size_t frames) {
  observe::Film film;
  for (std::size_t k = 0; k < frames; ++k) {
    observe::Frame frame{.t = 300.0 * static_cast<double>(k), .matrix = {}, .outline = {}, .protrusions = {}};
    const auto u = static_cast<float>(k);
    frame.matrix.f_degr = {1.0F, 0.5F, 0.0F};
    frame.matrix.displacement = {3.0F * u, 4.0F * u, 0.0F, 1.0F, 100.0F, 0.0F};
    frame.matrix.von_mises = {10.0F * u, 20.0F, 0.0F};
    film.frames.push_back(std::move(frame));
  }
  return film;
}

std::string table(const observe::Film& soft, const observe::Film& stiff) {
  return fields_header() + fields_rows("100 Pa", soft) + fields_rows("400 Pa", stiff);
}

TEST(FieldsShown, HoldsOfTwoWholeFilms) {
  const Finding finding = fields_shown(table(film(4), film(4)), 900.0);
  EXPECT_EQ(finding.verdict, Verdict::holds) << finding.brief;
  EXPECT_EQ(finding.brief, "100 Pa: up to 15 um and 30 Pa; 400 Pa: up to 15 um and 30 Pa") << "fluid is left out";
}

TEST(FieldsShown, DoesNotHoldOfLess) {
  EXPECT_EQ(fields_shown(table(film(4), film(3)), 900.0).verdict, Verdict::does_not_hold) << "a frame is missing";
  EXPECT_EQ(fields_shown(fields_header() + fields_rows("100 Pa", film(4)), 900.0).verdict, Verdict::does_not_hold);
  EXPECT_EQ(fields_shown(fields_header(), 900.0).verdict, Verdict::undecided);
  observe::Film broken = film(4);
  broken.frames[2].matrix.von_mises[1] = std::numeric_limits<float>::quiet_NaN();
  const Finding finding = fields_shown(table(film(4), broken), 900.0);
  EXPECT_EQ(finding.verdict, Verdict::does_not_hold);
  ASSERT_EQ(finding.unmet.size(), 1U);
  EXPECT_EQ(finding.unmet[0], "both fields defined at 400 Pa in each of 4 frames (3)");
  EXPECT_THROW(fields_shown("a,b\n1,2\n", 900.0), InputOutputError);
}

} // namespace
} // namespace matrigrate::study
