#include "parameters/judge.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace matrigrate {
namespace {

double number(const char* path, const char* text) {
  const Judged found = judged(path, {text, "a string"});
  EXPECT_EQ(found.fault, "") << path;
  return found.number;
}

TEST(Judge, GivesNumbersInTheDocumentedUnit) {
  EXPECT_EQ(number("ecm.youngs_modulus", "0.05 kPa"), 50.0);
  EXPECT_EQ(number("run.duration", "6 h 30 min"), 6.5);
  EXPECT_EQ(number("cells.y", "-0.02 mm"), -20.0);
  EXPECT_EQ(number("ecm.lattice", "square"), 0.0) << "is no number";
}

TEST(Judge, HasTheWordsOfTheReader) {
  EXPECT_EQ(judged("ecm.youngs_modulus", {"50 s", "a string"}).fault,
            "\"50 s\" is a time, but a stress is expected; write it like \"200 Pa\"");
  EXPECT_EQ(judged("ecm.youngs_modulus", {std::numeric_limits<double>::quiet_NaN(), "a number"}).fault,
            "nan is not a finite number");
  EXPECT_EQ(judged("ecm.youngs_modulus", {{}, "an array"}).fault,
            "is an array, but a number with its unit is expected, such as \"200 Pa\"");
  EXPECT_EQ(judged("ecm.youngs_modulu", {1.0, "a number"}).fault,
            "there is no such parameter; did you mean ecm.youngs_modulus?");
  EXPECT_EQ(unknown_name("emc", true), "there is no such section; did you mean ecm?");
}

} // namespace
} // namespace matrigrate
