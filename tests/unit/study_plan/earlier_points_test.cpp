#include "study_plan/earlier_points.hpp"

#include "parameters/schema.hpp"
#include "parameters/write.hpp"
#include "study_plan/read_study.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace matrigrate::study {
namespace {

/// A study that version 0.2.0 wrote out, beside its scenario.
class EarlierPoints : public testing::Test {
protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "matrigrate-points-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// @param more  rules of who computes
  Study read(const std::string& scenario, const std::string& points, std::span<const Rule> more = {}) const {
    std::ofstream(folder / "scenario.resolved.toml")
        << "version = \"0.2.5\"\n[ecm.fields]\nattractant = \"exp(x/50)\"\nligand = \"1\"\n"
        << scenario;
    return parse_study("# A study with all its points written out. Running this file again adds nothing.\n"
                       "scenario = \"scenario.resolved.toml\"\nreplicates = 1\n"
                           + points,
                       "s.toml", folder, {.overrides = {}, .replicates = {}, .more = more});
  }

  std::filesystem::path folder;
};

TEST_F(EarlierPoints, SayByLawsWhatTheySaidByCuesAndProfiles) {
  const Study s =
      read("[cues]\nchemotaxis = 5\nhaptotaxis = 0\nguidance = 0\n",
           "[[points]]\nlabel = \"a\"\n\"cues.chemotaxis\" = 20\n[[points]]\nlabel = \"b\"\n\"cues.chemotaxis\" = 0\n"
           "[[points]]\nlabel = \"c\"\n\"cues.haptotaxis\" = 2\n[[points]]\nlabel = \"d\"\n"
           "\"actomyosin.curvature_profile\" = \"triangle\"\n[[points]]\nlabel = \"e\"\n"
           "\"actomyosin.curvature_profile\" = \"half_gaussian\"\n");
  ASSERT_EQ(s.points.size(), 5U);
  const auto laws = [&](std::size_t k) { return s.points[k].parameters.laws; };
  EXPECT_EQ(laws(0).initiation_bias, "exp(20*occupancy)");
  EXPECT_EQ(laws(1).initiation_bias, "1");
  EXPECT_EQ(laws(2).initiation_bias, "exp(5*occupancy)*exp(2*ligand)") << "chemotaxis as in the scenario";
  EXPECT_EQ(laws(3).initiation_bias, "exp(5*occupancy)");
  EXPECT_EQ(laws(3).curvature_factor, "max(0, 1 - abs(kappa - kappa_0)/kappa_w)");
  EXPECT_EQ(laws(4).curvature_factor, *find_row("laws.curvature_factor")->before);
}

TEST_F(EarlierPoints, KeepReadingsThatHaveGoneForWhoReads) {
  const std::string points =
      "[[points]]\nlabel = \"place\"\n\"adhesion.hold\" = \"place\"\n[[points]]\nlabel = \"matter\"\n"
      "\"adhesion.hold\" = \"matter\"\n";
  const Study s = read("", points);
  ASSERT_EQ(s.points.size(), 2U);
  EXPECT_EQ(s.points[0].parameters.origin.gone.at("adhesion.hold"), "\"place\"");
  EXPECT_TRUE(s.points[1].parameters.origin.gone.empty());
  EXPECT_NE(values_text(s.points[0].parameters), values_text(s.points[1].parameters));
  try {
    read("", points, rules());
    FAIL() << "to compute it is refused";
  } catch (const ConfigurationError& error) {
    EXPECT_EQ(std::string(error.what()).find("s.toml:4:1: adhesion.hold: \"place\" has gone"), 0U) << error.what();
  }
}

TEST_F(EarlierPoints, AStudyThatSomebodyWroteIsRefusedThem) {
  std::ofstream(folder / "s.toml") << "version = \"0.2.5\"\n";
  EXPECT_THROW(
      parse_study("scenario = \"s.toml\"\nreplicates = 1\n[[points]]\nadhesion.hold = \"place\"\n", "e.toml", folder),
      ConfigurationError);
}

} // namespace
} // namespace matrigrate::study
