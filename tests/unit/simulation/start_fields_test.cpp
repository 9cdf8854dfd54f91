#include "simulation/start_fields.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "parameters/read.hpp"
#include "simulation/start.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace matrigrate {
namespace {

Parameters small(std::vector<std::string> overrides) {
  overrides.emplace_back("ecm.radius=60 um");
  return apply_overrides({}, overrides, start_rules());
}

std::string fault_of(const std::string& change) {
  try {
    small({change});
  } catch (const ConfigurationError& error) {
    return to_string(error.faults().front());
  }
  return "";
}

TEST(StartFields, AUniformFieldIsNone) {
  const State plain = initial_state(small({}));
  const State field = initial_state(small({"ecm.fields.youngs_modulus=\"200\"", "ecm.fields.f_degr=\"1\""}));
  EXPECT_TRUE(field.ecm.E_ratio.empty());
  EXPECT_EQ(field.ecm.f, plain.ecm.f);
}

TEST(StartFields, StiffnessIsThatOfTheReferencePosition) {
  const State s = initial_state(small({"ecm.fields.youngs_modulus=200 + x"}));
  ASSERT_EQ(s.ecm.E_ratio.size(), s.ecm.size());
  for (std::size_t i = 0; i < s.ecm.size(); ++i) EXPECT_NEAR(s.ecm.stiffness(i), 1.0 + s.ecm.X[i].x() / 200.0, 1e-12);
}

/// A CSV of two by two nodes, its value on the left and on the right.
std::string grid_file(const std::string& column, const std::string& left, const std::string& right) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / ("matrigrate-" + column + ".csv");
  std::string text = "x_um,y_um," + column + "\n";
  for (const char* y : {"-90", "90"}) text += fmt::format("-90,{0},{1}\n90,{0},{2}\n", y, left, right);
  write_file(file, text);
  return file.string();
}

TEST(StartFields, DirectionsInAFileHaveNoSense) {
  const auto angles = [](const std::string& file) {
    const std::vector<std::string> all{"fibres.arrangement=uniaxial", "fibres.field.direction_deg=" + file};
    const State s = initial_state(small(all));
    for (std::size_t i = 0; i < s.ecm.size(); ++i) // 10 degrees to either side of the y axis
      EXPECT_GE(std::abs(s.ecm.fibre_direction[i]), 79.9 * std::numbers::pi / 180.0) << s.ecm.X[i].x();
    EXPECT_LE(field_summaries(small(all)).fields[0].high, 90.0);
  };
  const std::string degrees = grid_file("angle", "80", "-80"), radians = grid_file("a_rad", "1.3963", "-1.3963");
  angles(degrees);
  angles(radians);
  EXPECT_NE(fault_of("fibres.field.direction_deg=" + grid_file("far", "500", "500")).find("is 500 at ("),
            std::string::npos);
  for (const char* name : {"angle", "a_rad", "far"})
    std::filesystem::remove(std::filesystem::temp_directory_path() / fmt::format("matrigrate-{}.csv", name));
}

TEST(StartFields, TheUnitInTheNameOfAColumnCounts) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const auto grid = [&](const std::string& column, const std::string& value) {
    return grid_file(column, value, value);
  };
  const std::string stiff = "ecm.fields.youngs_modulus=";
  const State s = initial_state(small({stiff + grid("E_kPa", "0.3"), "fibres.arrangement=uniaxial",
                                       "fibres.field.direction_deg=" + grid("direction_rad", "1.25")}));
  EXPECT_DOUBLE_EQ(s.ecm.stiffness(7), 1.5) << "of 200 Pa";
  EXPECT_DOUBLE_EQ(s.ecm.fibre_direction[7], 1.25);
  const FieldSummaries all = field_summaries(small({stiff + grid("E_kPa", "0.3")}));
  EXPECT_DOUBLE_EQ(all.fields[0].high, 300.0);
  EXPECT_NE(fault_of(stiff + grid("E_mm", "0.3")).find("column E_mm is in mm; wanted is Pa"), std::string::npos);
  EXPECT_EQ(fault_of("ecm.fields.attractant=" + grid("c_kg", "0.3")), "") << "its unit is the user's";
  for (const char* name : {"E_kPa", "direction_rad", "E_mm", "c_kg"})
    std::filesystem::remove(folder / ("matrigrate-" + std::string(name) + ".csv"));
}

TEST(StartFields, AChannelIsFluidAndTheRimStaysSolid) {
  const State s = initial_state(small({"ecm.fields.f_degr=abs(y) < 5 ? 0 : 1"}));
  for (std::size_t i = 0; i < s.ecm.size(); ++i) {
    if (s.ecm.clamped[i]) {
      EXPECT_EQ(s.ecm.f[i], 1.0);
    } else if (std::abs(s.ecm.X[i].y()) < 5.0) {
      EXPECT_EQ(s.ecm.f[i], 0.0);
    }
  }
}

TEST(StartFields, DirectionsOfFibresAreInRadians) {
  const State s = initial_state(small({"fibres.arrangement=uniaxial", "fibres.field.direction_deg=x < 0 ? 0 : 90"}));
  ASSERT_EQ(s.ecm.fibre_direction.size(), s.ecm.size());
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    EXPECT_DOUBLE_EQ(s.ecm.fibre_direction[i], s.ecm.X[i].x() < 0.0 ? 0.0 : 0.5 * std::numbers::pi);
}

TEST(StartFields, StiffnessOfFibresIsRelative) {
  const std::vector<std::string> fibres{"fibres.arrangement=isotropic", "fibres.stiffness=1000 Pa",
                                        "fibres.field.stiffness=x < 0 ? 500 : 2000"};
  const State s = initial_state(small(fibres));
  ASSERT_EQ(s.ecm.fibre_ratio.size(), s.ecm.size());
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    EXPECT_DOUBLE_EQ(s.ecm.fibre_ratio[i], s.ecm.X[i].x() < 0.0 ? 0.5 : 2.0);
  EXPECT_NEAR(as_stiff_everywhere(small(fibres)).fibres.stiffness, 2.0, 1e-12);
}

TEST(StartFields, ObstaclesAreClampedAndSolid) {
  const State s =
      initial_state(small({"ecm.fields.obstacle=abs(y) > 20 && abs(y) < 25 ? 1 : 0", "ecm.fields.f_degr=0*x"}));
  ASSERT_EQ(s.ecm.obstacle.size(), s.ecm.size());
  for (std::size_t i = 0; i < s.ecm.size(); ++i) {
    const double y = std::abs(s.ecm.X[i].y());
    EXPECT_EQ(s.ecm.in_obstacle(i), y > 20.0 && y < 25.0);
    if (s.ecm.in_obstacle(i)) {
      EXPECT_EQ(s.ecm.f[i], 1.0);
      EXPECT_NE(s.ecm.clamped[i], 0);
    }
  }
  EXPECT_TRUE(initial_state(small({"ecm.fields.obstacle=0*x"})).ecm.obstacle.empty()) << "none: the bits of none";
}

TEST(StartFields, EveryFaultNamesItsPlace) {
  EXPECT_NE(fault_of("ecm.fields.youngs_modulus=200 + 10*x").find("um; write a formula in x and y"), std::string::npos)
      << fault_of("ecm.fields.youngs_modulus=200 + 10*x");
  EXPECT_NE(fault_of("ecm.fields.youngs_modulus=195 + 10*x").find("is -"), std::string::npos) << "below 0 on the left";
  EXPECT_NE(fault_of("ecm.fields.youngs_modulus=sqrt(x - 1)").find("is not finite at ("), std::string::npos);
  EXPECT_NE(fault_of("ecm.fields.f_degr=2").find("is a number; write a formula"), std::string::npos);
  EXPECT_NE(fault_of("ecm.fields.f_degr=\"2\"").find("is 2 at ("), std::string::npos);
  EXPECT_NE(fault_of("ecm.fields.youngs_modulus=200 + z").find("cannot be read as a formula"), std::string::npos);
  EXPECT_NE(fault_of("ecm.fields.youngs_modulus=none.csv").find("none.csv"), std::string::npos);
  EXPECT_NE(fault_of("ecm.fields.stiffness=3").find("there is no such parameter"), std::string::npos);
  EXPECT_NE(fault_of("ecm.fields.obstacle=x > 10 ? 1 : 0").find("an obstacle lies on a cell, at ("), std::string::npos);
  EXPECT_NE(fault_of("ecm.fields.obstacle=3*x").find("um; write a formula"), std::string::npos);
  EXPECT_NE(fault_of("fibres.field.direction_deg=1000 + x").find("um; write a formula"), std::string::npos);
}

TEST(StartFields, TheStiffestPlaceBoundsTheStep) {
  const Parameters p = small({"ecm.fields.youngs_modulus=200 + x"});
  EXPECT_NEAR(as_stiff_everywhere(p).ecm.youngs_modulus, 0.26, 1e-3);
  EXPECT_NE(fault_of("ecm.fields.youngs_modulus=x > 0 ? 20000 : 200").find("step"), std::string::npos);
}

TEST(StartFields, AreSummedUp) {
  const FieldSummaries given = field_summaries(small({"ecm.fields.youngs_modulus=200 + x"}));
  const std::vector<FieldSummary>& all = given.fields;
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].row->path, "ecm.fields.youngs_modulus");
  EXPECT_EQ(all[0].source, "a formula");
  EXPECT_DOUBLE_EQ(all[0].low, 140.0);
  EXPECT_DOUBLE_EQ(all[0].high, 260.0);
  ASSERT_EQ(all[0].values.size(), given.places.size());
  for (std::size_t i = 0; i < given.places.size(); ++i) EXPECT_DOUBLE_EQ(all[0].values[i], 200.0 + given.places[i].x());
}

} // namespace
} // namespace matrigrate
