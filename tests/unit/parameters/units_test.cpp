#include "parameters/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace matrigrate::units {
namespace {

/// A quantity as typed, in internal units.
double internal(std::string_view text) {
  const Quantity quantity = parse_quantity(text);
  return to_internal(quantity.number, parse_unit(quantity.unit));
}

struct Case {
  const char* text;
  double expected;
};

class Conversion : public testing::TestWithParam<Case> {};

TEST_P(Conversion, HasTheVeryBits) { EXPECT_EQ(internal(GetParam().text), GetParam().expected) << GetParam().text; }

INSTANTIATE_TEST_SUITE_P(
    Table, Conversion,
    testing::Values(Case{"200 Pa", 0.2}, Case{"0.2 kPa", 0.2}, Case{"0.7 Pa", 0.0007}, Case{"20 Pa", 0.02},
                    Case{"1 MPa", 1000.0}, Case{"0.71 N/m^2", 0.71e-3}, Case{"0.2 nN/um^2", 0.2}, Case{"0.4 s", 0.4},
                    Case{"400 ms", 0.4}, Case{"6 h", 21600.0}, Case{"30 min", 1800.0}, Case{"1 d", 86400.0},
                    Case{"0.1 h", 360.0}, Case{"1.1 min", 66.0}, Case{"150 um", 150.0}, Case{"150 µm", 150.0},
                    Case{"150 μm", 150.0}, Case{"0.15 mm", 150.0}, Case{"0.015 cm", 150.0}, Case{"2600 nm", 2.6},
                    Case{"1e-6 m", 1.0}, Case{"1000 Pa s", 1.0}, Case{"1000 Pa*s", 1.0}, Case{"1000 Pa·s", 1.0},
                    Case{"1 kPa s", 1.0}, Case{"1 nN s/um^2", 1.0}, Case{"2.8e-3 N/m", 2.8}, Case{"2.8e-6 N/m", 2.8e-3},
                    Case{"2e-15 N m", 2.0}, Case{"1.4 N/m^1.5", 1.4}, Case{"1.4 nN/um^1.5", 1.4},
                    Case{"2.5e-3 N s/m", 2.5}, Case{"0.2 1/s", 0.2}, Case{"0.2 /s", 0.2}, Case{"0.2 s^-1", 0.2},
                    Case{"3.6 1/h", 0.001}, Case{"72 um/h", 0.02}, Case{"0.6 nN", 0.6}, Case{"600 pN", 0.6},
                    Case{"6e-10 N", 0.6}, Case{"20 1/nN", 20.0}, Case{"2e10 N^-1", 20.0}, Case{"-0.15 1/um", -0.15},
                    Case{"1000 kg/m^3", 1e-12}, Case{"1 kg m/s^2", 1e9}, Case{"1 N", 1e9}, Case{"4 um^0.5", 4.0},
                    Case{"4 m^0.5", 4000.0}, Case{"0.45", 0.45}, Case{"0.45 1", 0.45}, Case{"+.5 um", 0.5},
                    Case{"5. um", 5.0}, Case{"200Pa", 0.2}, Case{"  6  h ", 21600.0}, Case{"1E3 Pa", 1.0},
                    Case{"0 Pa", 0.0}, Case{"1 um/s/s", 1.0}, Case{"1 hour", 3600.0}, Case{"2 hours", 7200.0},
                    Case{"90 minutes", 5400.0}, Case{"30 seconds", 30.0}, Case{"2 days", 172800.0},
                    Case{"1 um/hour", 1.0 / 3600.0}, Case{"6 h 30 min", 23400.0}, Case{"6h 30min", 23400.0},
                    Case{"6h30min", 23400.0}, Case{"1 d 2 h 3 min 4.5 s", 93784.5}, Case{"1.05 rad", 1.05},
                    Case{"60 deg", 1.0471975511965976}, Case{"60°", 1.0471975511965976},
                    Case{"180 degrees", 3.141592653589793}, Case{"0.2 deg/s", 0.0034906585039886592}));

TEST(Units, AnAngleByItsOwnUnitIsABareNumber) {
  const Unit same = quotient(parse_unit("deg"), parse_unit("°"));
  EXPECT_TRUE(same.decimal());
  EXPECT_EQ(same.dimension, Dimension{});
  EXPECT_EQ(to_internal("0.1", same), 0.1);
  EXPECT_NEAR(to_internal("1", quotient(parse_unit("rad"), parse_unit("deg"))), 57.29577951308232, 1e-14);
}

TEST(Units, ADecimalCommaIsRefusedWithItsPoint) {
  try {
    parse_quantity("0,2 kPa");
    FAIL() << "was read";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "has a comma; did you mean \"0.2 kPa\"?");
  }
}

TEST(Units, RootsOfPrefixesAreRead) {
  EXPECT_NEAR(internal("1 mm^0.5"), std::sqrt(1000.0), 1e-12);
  EXPECT_NEAR(internal("1 1/mm^0.5"), 1.0 / std::sqrt(1000.0), 1e-15);
  EXPECT_NEAR(internal("44.27 uN/mm^1.5"), internal("1.4 N/m^1.5"), 1e-3 * internal("1.4 N/m^1.5"));
  EXPECT_NEAR(internal("5 1/min^0.5"), 5.0 / std::sqrt(60.0), 1e-14);
  EXPECT_NEAR(internal("5 pN^0.5"), 5.0 * std::sqrt(1e-3), 1e-14);
}

TEST(Units, DimensionsFollowFromSymbols) {
  EXPECT_EQ(parse_unit("Pa").dimension, (Dimension{-2000, 0, 1000}));
  EXPECT_EQ(parse_unit("Pa").dimension, parse_unit("N/m^2").dimension);
  EXPECT_EQ(parse_unit("kg/m^3").dimension, parse_unit("N s^2/m^4").dimension);
  EXPECT_EQ(parse_unit("N/m^1.5").dimension, (Dimension{-1500, 0, 1000}));
  EXPECT_EQ(parse_unit("um/um").dimension, Dimension{});
  EXPECT_EQ(parse_unit("").dimension, parse_unit("1").dimension);
  EXPECT_NE(parse_unit("Pa s").dimension, parse_unit("Pa").dimension);
}

TEST(Units, MinutesAreNotMilliInches) {
  EXPECT_EQ(internal("1 min"), 60.0);
  EXPECT_EQ(internal("1 mm"), 1000.0);
  EXPECT_EQ(internal("1 ms"), 0.001);
}

class NoUnit : public testing::TestWithParam<const char*> {};

TEST_P(NoUnit, IsRefused) { EXPECT_THROW(parse_unit(GetParam()), std::invalid_argument) << GetParam(); }

INSTANTIATE_TEST_SUITE_P(Table, NoUnit,
                         testing::Values("Pascal", "pa", "PA", "kh", "kmin", "Pa/", "/", "Pa^", "Pa^x", "Pa^1.2345",
                                         "m^99", "m^-", "Pa**2", "(N)", "10/s", "2", "m2", "°C", "\xff", "Pa//s"));

TEST(Units, LongTextIsRefused) {
  EXPECT_THROW(parse_unit(std::string(1000, 'm')), std::invalid_argument);
  EXPECT_THROW(parse_quantity(std::string(1000, '1')), std::invalid_argument);
}

class NoQuantity : public testing::TestWithParam<const char*> {};

TEST_P(NoQuantity, IsRefused) { EXPECT_THROW(internal(GetParam()), std::invalid_argument) << GetParam(); }

INSTANTIATE_TEST_SUITE_P(Table, NoQuantity,
                         testing::Values("", " ", "Pa", "nan Pa", "inf Pa", "-inf", "1e999 Pa",
                                         "1e99999999999999999999 h", ". Pa", "- 5 Pa", "0x10 Pa", "1,5 Pa", "1e Pa",
                                         "1 2 Pa", "--1 s", "1e400 h", "6 h 30", "6 h -30 min", "6 h 30 Pa",
                                         "6 Pa 30 min", "6 h, 30 min", "1 hourss", "1 h^2 3 min"));

TEST(Units, ADecimalUnitHoldsEveryDouble) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> magnitude(-30.0, 30.0);
  for (const char* name : {"Pa", "um", "nm", "Pa s", "N/m", "s", "1/s", "N/m^1.5", "kg/m^3"}) {
    const Unit unit = parse_unit(name);
    ASSERT_TRUE(unit.decimal()) << name;
    for (int i = 0; i < 2000; ++i) {
      const double value = std::pow(10.0, magnitude(random)) * (i % 2 == 0 ? 1.0 : -1.0);
      EXPECT_EQ(to_internal(from_internal(value, unit), unit), value) << name;
    }
  }
}

TEST(Units, NumbersComeBackAsPeopleWriteThem) {
  EXPECT_EQ(from_internal(0.2, parse_unit("Pa")), "200");
  EXPECT_EQ(from_internal(1.0, parse_unit("Pa s")), "1000");
  EXPECT_EQ(from_internal(2.6, parse_unit("um")), "2.6");
  EXPECT_EQ(from_internal(21600.0, parse_unit("h")), "6");
  EXPECT_EQ(from_internal(360.0, parse_unit("h")), "0.1");
  EXPECT_EQ(from_internal(0.0, parse_unit("Pa")), "0");
}

TEST(Units, AnHourDoesNotHoldEveryDouble) {
  EXPECT_EQ(from_internal(21600.1234567891, parse_unit("h")), "");
  EXPECT_EQ(number_in(1800.0, parse_unit("h")), 0.5);
  EXPECT_DOUBLE_EQ(number_in(1320.0, parse_unit("h")), 22.0 / 60.0) << "no short decimal";
  EXPECT_FALSE(parse_unit("h").decimal());
}

TEST(Units, OtherLettersAreHintedAt) {
  EXPECT_EQ(unit_meant("kpa"), "; did you mean kPa?");
  EXPECT_EQ(unit_meant("MINUTES"), "; did you mean minute?");
  EXPECT_EQ(unit_meant("Pascal"), "; did you mean Pa?");
  EXPECT_EQ(unit_meant("furlong"), "");
}

TEST(Units, DimensionsHaveWords) {
  EXPECT_EQ(to_string(parse_unit("Pa").dimension), "a stress");
  EXPECT_EQ(to_string(parse_unit("mm").dimension), "a length");
  EXPECT_EQ(to_string(parse_unit("").dimension), "a bare number");
  EXPECT_EQ(to_string(parse_unit("deg").dimension), "an angle");
  EXPECT_EQ(to_string(parse_unit("N/m^1.5").dimension), "a quantity in um^-1.5 nN");
}

} // namespace
} // namespace matrigrate::units
