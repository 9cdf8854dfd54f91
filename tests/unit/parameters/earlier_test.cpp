#include "parameters/version.hpp"

#include "parameters/read.hpp"
#include "parameters/rules.hpp"
#include "parameters/schema.hpp"
#include "parameters/write.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>

namespace matrigrate {
namespace {

/// The lines of a resolved file without those of some parameters, as a program wrote it that did not have them.
template <class Left>
std::string resolved_without(const Parameters& p, const Left& left_out) {
  std::string text = to_toml(p);
  for (const Row& row : schema()) {
    if (!left_out(row)) continue;
    const std::size_t section = text.find("\n[" + std::string(section_of(row)) + "]\n");
    const bool is_table = kind(row) == Kind::constants;
    const std::size_t line =
        text.find("\n" + (is_table ? "[" + std::string(row.path) : std::string(key_of(row)) + " = "), section);
    EXPECT_NE(line, std::string::npos) << row.path;
    text.erase(line, text.find('\n', line + 1) - line);
  }
  return text;
}

bool came_later(const Row& row) { return row.before.has_value(); }

/// Every parameter that came later at what was done before.
Parameters all_before() {
  std::vector<std::string> overrides{"run.integrator=adaptive"};
  for (const Row& row : schema())
    if (row.before) overrides.push_back(std::string(row.path) + "=" + before_text(row, {}));
  return apply_overrides({}, overrides);
}

TEST(Earlier, EveryValueOfBeforeIsWrittenAsTheProgramWritesIt) {
  for (const Row& row : schema()) {
    if (!row.before) continue;
    const Parameters p = apply_overrides({}, {std::string(row.path) + "=" + before_text(row, {})});
    EXPECT_EQ(value_text(row, p), before_text(row, p)) << row.path << ": otherwise the value is never left out";
    EXPECT_FALSE(counts(row, p)) << row.path;
  }
}

TEST(Earlier, ANewParameterSaysWhatWasDoneBefore) {
  const auto of_all_versions =
      std::ranges::count_if(schema(), [](const Row& row) { return !row.before && row.of_part == nullptr; });
  EXPECT_EQ(of_all_versions, 89) << "a new row needs `before`, the value at which nothing changes: otherwise all "
                                    "finished runs get other names, and files of earlier versions count as damaged";
}

TEST(Earlier, AResolvedFileWithoutALaterKeyMeansWhatWasDoneBefore) {
  const Parameters first = all_before();
  const std::string text = resolved_without(first, came_later);
  const Parameters p = parse_parameters(text, "earlier.toml");
  EXPECT_TRUE(same(p, first));
  EXPECT_EQ(p.adhesion.rest_speed, 0.0);
  EXPECT_EQ(values_text(p), values_text(first)) << "the fingerprint is that of the earlier runs";
  EXPECT_EQ(values_text(p).find("rest_speed"), std::string::npos);
}

TEST(Earlier, TheKeyVersionOrTheFirstLineOfEarlierFilesTellsThatAProgramWroteIt) {
  const std::string body = "[cell]\ncentre_of_mass = \"particles\"\n[adhesion]\nhold = \"matter\"\n";
  const auto rest_speed = [](const std::string& text) { return parse_parameters(text, "f.toml").adhesion.rest_speed; };
  EXPECT_GT(rest_speed(body), 0.0) << "a scenario that somebody wrote takes today's defaults";
  EXPECT_EQ(rest_speed("version = \"0.3.0\"\n" + body), 0.0);
  EXPECT_EQ(rest_speed(std::string(resolved_head) + body), 0.0);
  EXPECT_EQ(rest_speed("version = \"0.2.0\"\n[adhesion]\nrest_speed = \"3 nm/s\"\n"), 0.003);
  EXPECT_NE(to_toml({}).find("\nversion = \"" + std::string(this_version) + "\"\n"), std::string::npos);
}

TEST(Earlier, AProfileOfTheCurvatureThatIsStillReadMeansItsLaw) {
  const std::string profile = "[actomyosin]\ncurvature_profile = \"half_gaussian\"\n";
  const std::string before(*find_row("laws.curvature_factor")->before);
  EXPECT_NE(Parameters{}.laws.curvature_factor, before);
  EXPECT_EQ(parse_parameters(profile, "f.toml").laws.curvature_factor, before);
  EXPECT_EQ(apply_overrides({}, {"actomyosin.curvature_profile=half_gaussian"}).laws.curvature_factor, before);
  EXPECT_EQ(parse_parameters(profile + "[laws]\ncurvature_factor = \"1\"\n", "f.toml").laws.curvature_factor, "1");
}

TEST(Earlier, AKeyOfALaterVersionIsToldAsSuch) {
  const auto fault = [](const std::string& text) {
    try {
      parse_parameters(text, "f.toml");
    } catch (const ConfigurationError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string later = fault("version = \"9.0.0\"\n[cell]\nglow = 1\n");
  EXPECT_NE(later.find("in version " + std::string(this_version) + "; the file was written by version 9.0.0"),
            std::string::npos)
      << later;
  EXPECT_EQ(fault("version = \"" + std::string(this_version) + "\"\n[cell]\nglow = 1\n").find("written by"),
            std::string::npos);
  EXPECT_NE(fault("version = 2\n").find("version: is a number"), std::string::npos) << fault("version = 2\n");
  EXPECT_NE(fault("version = \"\"\n"), "");
}

std::string fault_in(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_parameters(text, "f.toml", overrides);
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return {};
}

/// "adhesion.hold = value" as a file has it.
std::string file_with(std::string_view path, std::string_view value) {
  const std::size_t dot = path.rfind('.');
  return fmt::format("[{}]\n{} = {}\n", path.substr(0, dot), path.substr(dot + 1), value);
}

TEST(Earlier, AParameterThatHasGoneMayHaveTheValueThatIsLeft) {
  for (const Gone& parameter : gone()) {
    EXPECT_EQ(find_row(parameter.path), nullptr) << parameter.path;
    const bool counted = !parameter.behind.empty();
    EXPECT_EQ(counted, find_row(parameter.behind) != nullptr) << parameter.behind;
    const std::string line = fmt::format("\n{} = {}\n", parameter.path, parameter.left);
    EXPECT_EQ(values_text({}).find(line) != std::string::npos, counted) << "the fingerprint of earlier runs holds it";
    Parameters meant; // the law that the profile names is no longer the default
    if (parameter.path == "actomyosin.curvature_profile")
      meant.laws.curvature_factor = *find_row("laws.curvature_factor")->before;
    const Parameters p = parse_parameters(file_with(parameter.path, parameter.left), "f.toml");
    EXPECT_TRUE(same(p, meant)) << parameter.path;
    EXPECT_TRUE(same(apply_overrides({}, {fmt::format("{}={}", parameter.path, parameter.left)}), meant));
  }
}

TEST(Earlier, AnotherValueOfAParameterThatHasGoneIsRefusedWithWhatBecameOfIt) {
  for (const Gone& parameter : gone()) {
    if (!parameter.law.empty() || parameter.is_drawing) continue;
    const std::string fault = fault_in(file_with(parameter.path, "\"else\""));
    EXPECT_EQ(fault,
              fmt::format("f.toml:2:{}: {}: \"else\" has gone: {}; the version of the tag closures-2 has the "
                          "other readings",
                          parameter.path.size() - parameter.path.rfind('.') + 3, parameter.path, parameter.fate));
  }
  EXPECT_EQ(fault_in("", {"adhesion.hold=place"}),
            "--set: adhesion.hold: \"place\" has gone: an adhesion holds the matter that was there when it formed; the "
            "version of the tag closures-2 has the other readings");
  EXPECT_EQ(fault_in("[cues]\nchemotaxis = 20\n"),
            "f.toml:2:14: cues.chemotaxis: 20 has gone: write laws.initiation_bias = \"exp(20*occupancy)\"");
  EXPECT_EQ(fault_in("", {"cues.haptotaxis=4"}),
            "--set: cues.haptotaxis: 4 has gone: write laws.initiation_bias = \"exp(4*ligand)\"");
  EXPECT_EQ(fault_in("[adhesion]\nrupture_strands = 1\n").find("f.toml:2:19: adhesion.rupture_strands: 1 has gone: "),
            0U);
  EXPECT_NE(fault_in("[fibres]\nplane_to_space = [3]\n").find("fibres.plane_to_space: [ 3 ] has gone"),
            std::string::npos);
  EXPECT_EQ(fault_in("[actomyosin]\ncurvature_profile = \"gaussian\"\n"),
            "f.toml:2:21: actomyosin.curvature_profile: \"gaussian\" has gone: write laws.curvature_factor = "
            "\"exp(-((kappa - kappa_0)/kappa_w)^2)\" for \"gaussian\", \"max(0, 1 - abs(kappa - kappa_0)/kappa_w)\" "
            "for \"triangle\"");
}

TEST(Earlier, AnyValueOfADrawingThatHasGoneIsReadAndDecidesNothing) {
  const auto drawings = std::ranges::count_if(gone(), &Gone::is_drawing);
  EXPECT_EQ(drawings, 4);
  for (const Gone& parameter : gone())
    for (const char* value : {"true", "false", "\"60 s\"", "7"})
      if (parameter.is_drawing) {
        EXPECT_EQ(values_text(parse_parameters(file_with(parameter.path, value), "f.toml")), values_text({}));
      }
}

/// The faults of a file for who computes.
std::string fault_of_computing(const std::string& text) {
  try {
    parse_parameters(text, "f.toml", {}, rules());
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return {};
}

/// Those that came before the key `version`, of the first closures.
TEST(Earlier, AResolvedFileThatMeansAReadingThatHasGoneIsReadButNotComputed) {
  const std::string text = std::string(resolved_head) + "[cell]\ncentre_of_mass = \"particles\"\n";
  const Parameters p = parse_parameters(text, "f.toml");
  EXPECT_EQ(p.origin.gone, (std::map<std::string, std::string, std::less<>>{{"adhesion.hold", "\"place\""}}));
  EXPECT_EQ(p.origin.version, "0.2.0");
  EXPECT_EQ(
      fault_of_computing(text),
      "f.toml: adhesion.hold: \"place\" has gone: an adhesion holds the matter that was there when it formed; the "
      "version of the tag closures-2 has the other readings");
}

TEST(Earlier, EveryReadingThatHasGoneIsKeptAsItStandsAndDecidesOnTheName) {
  for (const Gone& parameter : gone()) {
    if (!parameter.law.empty() || parameter.is_drawing) continue;
    const std::string text = "version = \"0.2.5\"\n" + file_with(parameter.path, "\"else\"");
    const Parameters p = parse_parameters(text, "f.toml");
    EXPECT_EQ(p.origin.gone.at(std::string(parameter.path)), "\"else\"");
    EXPECT_NE(values_text(p).find(fmt::format("\n{} = \"else\"\n", parameter.path)), std::string::npos);
    const Parameters left = parse_parameters("version = \"0.2.5\"\n" + file_with(parameter.path, parameter.left), "");
    EXPECT_TRUE(left.origin.gone.empty());
    EXPECT_FALSE(same(p, left)) << parameter.path;
    EXPECT_EQ(fault_of_computing(text).find(fmt::format("f.toml:3:{}: {}: \"else\" has gone",
                                                        parameter.path.size() - parameter.path.rfind('.') + 3,
                                                        parameter.path)),
              0U)
        << fault_of_computing(text);
  }
}

TEST(Earlier, WhatALawSaysNowIsReadAsTheLawInAFileThatAProgramWrote) {
  const auto read = [](const std::string& text) {
    return parse_parameters("version = \"0.2.5\"\n" + text, "", {}, rules());
  };
  const auto profile = [&](const std::string& name) {
    return read("[actomyosin]\ncurvature_profile = \"" + name + "\"\n").laws.curvature_factor;
  };
  EXPECT_EQ(profile("triangle"), "max(0, 1 - abs(kappa - kappa_0)/kappa_w)");
  EXPECT_EQ(profile("gaussian"), "exp(-((kappa - kappa_0)/kappa_w)^2)");
  EXPECT_EQ(profile("half_gaussian"), *find_row("laws.curvature_factor")->before);
  const std::string sensed = "[ecm.fields]\nattractant = \"1 + x/100\"\nligand = \"1\"\n[fibres]\narrangement = "
                             "\"uniaxial\"\n";
  const auto bias = [&](const std::string& cues) { return read(sensed + "[cues]\n" + cues).laws.initiation_bias; };
  EXPECT_EQ(bias("chemotaxis = 20\nhaptotaxis = 0\n"), "exp(20*occupancy)");
  EXPECT_EQ(bias("chemotaxis = 2.5\nhaptotaxis = -4\nguidance = 1\n"),
            "exp(2.5*occupancy)*exp(-4*ligand)*exp(1*alignment)");
  EXPECT_EQ(bias("chemotaxis = 0\n"), "1");
  EXPECT_TRUE(read(sensed + "[cues]\nchemotaxis = 20\n").origin.gone.empty());
  EXPECT_NE(fault_in("version = \"0.2.5\"\n[actomyosin]\ncurvature_profile = \"square\"\n"), "");
}

TEST(Earlier, AVersionHasTodaysModelOrNot) {
  for (const char* version : {"0.3.0", this_version.data()}) {
    EXPECT_TRUE(has_this_model(version)) << version;
    EXPECT_EQ(parse_parameters(fmt::format("version = \"{}\"\n", version), "").origin.version, "");
  }
  for (const char* version : {"0.2.0", "0.2.9", "0.1.0", "9.0.0", "0.10.0", "unknown"}) {
    EXPECT_FALSE(has_this_model(version)) << version;
    EXPECT_EQ(parse_parameters(fmt::format("version = \"{}\"\n", version), "").origin.version, version);
  }
  EXPECT_EQ(parse_parameters(std::string(resolved_head) + "[adhesion]\nhold = \"matter\"\n", "").origin.version,
            "0.2.0");
  EXPECT_EQ(parse_parameters("[ecm]\nradius = \"60 um\"\n", "").origin.version, "") << "somebody wrote it";
  EXPECT_EQ(version_of_program("matrigrate 0.2.0 (9a32bbbb, changed sources)"), "0.2.0");
  EXPECT_NE(model_text("0.2.0").find("has changed since 0.2.0"), std::string::npos);
  EXPECT_NE(model_text("9.0.0").find("a later version"), std::string::npos);
}

TEST(Earlier, APartThatIsOffDecidesNothing) {
  Parameters p;
  p.nucleus.shear_modulus = 7.0;
  p.contact.cells.adhesion = 1.0;
  EXPECT_EQ(values_text(p), values_text({}));
  p.nucleus.radius = 5.0;
  p.cells = {{-20.0, 0.0}, {20.0, 0.0}};
  const std::string text = values_text(p);
  EXPECT_NE(text.find("nucleus.drag = "), std::string::npos) << "of a nucleus every value, as fingerprints have had it";
  EXPECT_NE(text.find("contact.cells.repulsion = "), std::string::npos);
}

} // namespace
} // namespace matrigrate
