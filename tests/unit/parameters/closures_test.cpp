#include "parameters/closures.hpp"

#include "parameters/presets.hpp"
#include "parameters/read.hpp"

#include <gtest/gtest.h>

namespace matrigrate {
namespace {

Closures of(const std::vector<std::string>& overrides) { return closures_of(apply_overrides({}, overrides)); }

TEST(Closures, EveryPresetButOneIsOfTheThirdSet) {
  for (const Preset& preset : presets()) {
    const Closures closures = closures_of(parameters_of(preset));
    EXPECT_EQ(closures_text(closures), preset.name == "second-closures" ? "second set" : "third set") << preset.name;
    EXPECT_EQ(closures_note(closures).empty(), preset.name != "second-closures");
  }
}

TEST(Closures, TheFirstSetIsKnownByItsNumbers) {
  const Closures closures =
      of({"cell.bending_stiffness=5e-17 N m", "contact.fluid_share=0.1", "contact.body_fluid_share=0.1",
          "protrusion.least_facing=0.8", "adhesion.rest_speed=0 nm/s",
          "laws.curvature_factor=max(0, 1 - abs(kappa - kappa_0)/kappa_w)"});
  EXPECT_EQ(closures_text(closures), "first set");
  EXPECT_NE(closures_note(closures).find("tag closures-2"), std::string::npos);
}

/// As a scenario of version 0.2.0 that `new` wrote.
TEST(Closures, ValuesOfTwoSetsAreMixed) {
  const Closures closures = of({"cell.bending_stiffness=5e-17 N m", "contact.fluid_share=0.15"});
  EXPECT_EQ(closures.set, "mixed");
  const std::string text = closures_text(closures);
  EXPECT_NE(text.find("; of the second cell.bending_stiffness = \"5e-17 N m\", contact.fluid_share = 0.15"),
            std::string::npos)
      << text;
  for (const char* key :
       {"contact.body_fluid_share", "protrusion.least_facing", "adhesion.rest_speed", "laws.curvature"})
    EXPECT_LT(text.find(key), text.find("; of the second")) << key << ": " << text;
  EXPECT_NE(closures_note(closures).find("--preset second-closures"), std::string::npos);
  const std::string three = closures_text(of({"contact.fluid_share=0.1", "protrusion.least_facing=0.8"}));
  EXPECT_NE(three.find("; of the second protrusion.least_facing = 0.8; of the first contact.fluid_share = 0.1"),
            std::string::npos)
      << three;
}

TEST(Closures, AValueOfNoSetChangesNone) {
  EXPECT_EQ(closures_text(of({"adhesion.rest_speed=2 nm/s"})), "third set, but for adhesion.rest_speed = \"2 nm/s\"");
  EXPECT_EQ(closures_note(of({"adhesion.rest_speed=2 nm/s"})), "");
  EXPECT_EQ(closures_text(of({"ecm.youngs_modulus=50 Pa", "adhesion.zeta_diss=80 1/nN"})), "third set");
}

} // namespace
} // namespace matrigrate
