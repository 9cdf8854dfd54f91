#include "parameters/column_unit.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>
#include <string>

namespace matrigrate::units {
namespace {

std::string refusal(const char* name, const char* wanted) {
  try {
    factor_of_column(name, wanted);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ColumnUnit, IsConvertedToTheWantedOne) {
  EXPECT_EQ(factor_of_column("E_Pa", "Pa"), 1.0);
  EXPECT_EQ(factor_of_column("E_kPa", "Pa"), 1000.0);
  EXPECT_EQ(factor_of_column("mean_E_MPa", "Pa"), 1e6);
  EXPECT_EQ(factor_of_column("E (kPa)", "Pa"), 1000.0);
  EXPECT_EQ(factor_of_column("E [nN/um^2]", "Pa"), 1000.0);
  EXPECT_DOUBLE_EQ(factor_of_column("direction_rad", "deg"), 180.0 / std::numbers::pi);
  EXPECT_EQ(factor_of_column("direction_deg", "deg"), 1.0);
}

TEST(ColumnUnit, IsNoneWhereANameHasNone) {
  for (const char* name : {"E", "E_mean", "f_degr", "E_1", "E_s", "kPa", "E (AFM)", "", "_", "()"})
    EXPECT_EQ(factor_of_column(name, "Pa"), 1.0) << name;
}

TEST(ColumnUnit, IsRefusedIfItIsOfAnotherKindOrMisspelt) {
  EXPECT_EQ(refusal("height_um", "Pa"), "column height_um is in um; wanted is Pa");
  EXPECT_EQ(refusal("E_kPa", "1"), "column E_kPa is in kPa; wanted is a number without a unit");
  EXPECT_EQ(refusal("E_kpa", "Pa"), "column E_kpa: kpa is no unit; did you mean kPa?");
  EXPECT_EQ(refusal("E_kilopascal", "Pa"), "column E_kilopascal: kilopascal is no unit; did you mean kPa?");
}

} // namespace
} // namespace matrigrate::units
