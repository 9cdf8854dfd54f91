#include "parameters/earlier.hpp"

#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "parameters/write.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
    const std::size_t line = text.find("\n" + std::string(key_of(row)) + " = ", section);
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
  EXPECT_EQ(of_all_versions, 103) << "a new row needs `before`, the value at which nothing changes: otherwise all "
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
  const std::string body = "[adhesion]\nhold = \"place\"\n";
  const auto rest_speed = [](const std::string& text) { return parse_parameters(text, "f.toml").adhesion.rest_speed; };
  EXPECT_GT(rest_speed(body), 0.0) << "a scenario that somebody wrote takes today's defaults";
  EXPECT_EQ(rest_speed("version = \"0.3.0\"\n" + body), 0.0);
  EXPECT_EQ(rest_speed(std::string(resolved_head) + body), 0.0);
  EXPECT_EQ(rest_speed("version = \"0.2.0\"\n[adhesion]\nrest_speed = \"3 nm/s\"\n"), 0.003);
  EXPECT_NE(to_toml({}).find("\nversion = \"" + std::string(this_version) + "\"\n"), std::string::npos);
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
