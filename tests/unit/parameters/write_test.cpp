#include "base/file.hpp"
#include "parameters/assign.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/read.hpp"
#include "parameters/rules.hpp"
#include "parameters/schema.hpp"
#include "parameters/write.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <random>
#include <regex>
#include <set>
#include <span>
#include <sstream>

namespace matrigrate {
namespace {

std::string committed(const std::string& path) {
  return read_file(std::filesystem::path(MATRIGRATE_SOURCE_DIR) / path, 1 << 20);
}

/// Each parameter at random, a quantity within a factor of `spread` of its default, with all bits of its mantissa in
/// use.
class RandomParameters {
public:
  explicit RandomParameters(unsigned seed) : m_random(seed) {}

  Parameters draw(double spread) {
    Parameters p;
    for (const Row& row : schema()) {
      const Parameters before = p;
      do {
        p = before;
        std::visit([&](const auto& member) { change(row, member, p, spread); }, row.member);
      } while (!in_range(row, p));
    }
    return p;
  }

private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_random); }

  void change(const Row&, double& (*member)(Parameters&), Parameters& p, double spread) {
    member(p) *= std::exp(uniform(-std::log(spread), std::log(spread)));
  }
  void change(const Row& row, int& (*member)(Parameters&), Parameters& p, double) {
    member(p) = static_cast<int>(uniform(row.range.low, row.range.high));
  }
  void change(const Row&, std::uint64_t& (*member)(Parameters&), Parameters& p, double) {
    member(p) = m_random() >> 11;
  }
  void change(const Row&, bool& (*member)(Parameters&), Parameters& p, double) { member(p) = m_random() % 2 == 0; }
  void change(const Row& row, std::string& (*member)(Parameters&), Parameters& p, double) {
    if (kind(row) == Kind::law) {
      if (m_random() % 2 == 0) member(p) = fmt::format("{}*n > 0 ? F_c : 1", uniform(0.0, 1.0));
      return;
    }
    member(p) = m_random() % 2 == 0 ? "" : fmt::format("\"/sp ace/\\\"{}\\\\.csv\" hash=1", m_random()); // unread
  }
  void change(const Row&, std::vector<LawConstant>& (*member)(Parameters&), Parameters& p, double) {
    member(p) = constants_in(fmt::format("n = {}, F_c = {} nN", uniform(-1.0, 1.0), m_random()));
  }
  void change(const Row&, const OneConstant&, Parameters&, double) {} // no row of the schema
  void change(const Row&, const Choice& choice, Parameters& p, double) {
    choice.set(p, m_random() % choice.names.size());
  }

  static bool in_range(const Row& row, Parameters& p) {
    const auto* member = std::get_if<double& (*)(Parameters&)>(&row.member);
    if (member == nullptr) return true;
    const double value = (*member)(p);
    const units::Unit unit = unit_of(row);
    const double low = units::to_internal(row.range.low, unit);
    const bool above = value > low || (value == 0.0 && low == 0.0 && row.range.low_allowed); // 0 stays 0
    return above && value < units::to_internal(row.range.high, unit);
  }

  std::mt19937_64 m_random;
};

bool rules_hold(const Parameters& p) {
  return std::ranges::all_of(
      rules(), [&](const Rule& rule) { return (rule.matters && !rule.matters(p)) || rule.broken(p).empty(); });
}

TEST(Write, TheResolvedFileReadsBackToTheSameBits) {
  EXPECT_TRUE(same(parse_parameters(to_toml({}), "f.toml"), Parameters{}));
  RandomParameters random(3);
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    const Parameters p = random.draw(1.3);
    if (!rules_hold(p)) continue;
    ++compared;
    const std::string text = to_toml(p);
    ASSERT_TRUE(same(parse_parameters(text, "f.toml"), p)) << text;
  }
  EXPECT_GT(compared, 240);
}

TEST(Write, EveryValueOfEveryRangeReadsBackToTheSameBits) {
  RandomParameters random(5);
  for (int i = 0; i < 500; ++i) {
    const Parameters p = random.draw(1e6);
    for (const Row& row : schema()) {
      const auto* member = std::get_if<double& (*)(Parameters&)>(&row.member);
      if (member == nullptr || kind(row) != Kind::quantity) continue;
      const std::string text = value_text(row, p);
      Parameters q;
      ASSERT_EQ(assign(row, {text.substr(1, text.size() - 2), "a string"}, q), "") << row.path << " = " << text;
      Parameters copy = p;
      ASSERT_EQ((*member)(q), (*member)(copy)) << row.path << " = " << text;
    }
  }
}

TEST(Write, AFormulaOnSeveralLinesReadsBack) {
  const Parameters p = parse_parameters("[ecm.fields]\nyoungs_modulus = \"\"\"200\n  + x\n\t+ y\"\"\"\n", "lines.toml");
  EXPECT_TRUE(same(parse_parameters(to_toml(p), "written.toml"), p)) << to_toml(p);
}

TEST(Write, EveryParameterStandsInTheResolvedFile) {
  const std::string text = to_toml({});
  for (const Row& row : schema())
    EXPECT_NE(
        text.find(kind(row) == Kind::constants ? "\n[laws.constants]\n" : "\n" + std::string(key_of(row)) + " = "),
        std::string::npos)
        << row.path;
}

TEST(Write, TheTextOfValuesHasNoWordOfDescription) {
  const std::string text = values_text({});
  EXPECT_EQ(text.find('#'), std::string::npos);
  EXPECT_TRUE(text.starts_with("run.duration = \"6 h\"\n")) << text;
  for (const Row& row : schema()) {
    const std::string value = row.unit == "rad" ? "1.0471975511965976" : value_text(row, {}); // not in degrees here
    EXPECT_EQ(text.find(std::string(row.path) + " = " + value + "\n") != std::string::npos, counts(row, {}))
        << row.path;
  }
  Parameters p;
  p.laws.initiation_bias = "exp(2*occupancy)";
  p.cells = {{-20.0, 0.0}, {20.0, 0.0}};
  EXPECT_NE(values_text(p).find("laws.initiation_bias = \"exp(2*occupancy)\"\n"), std::string::npos);
  EXPECT_NE(values_text(p).find("contact.cells.adhesion = "), std::string::npos);
}

TEST(Write, AResolvedFileOfAnEarlierVersionHasOneFluidShare) {
  Parameters one;
  one.contact.fluid_share = one.contact.body_fluid_share = 0.3;
  EXPECT_EQ(values_text(one).find("body_fluid_share"), std::string::npos) << "the fingerprint is that of earlier runs";
  std::string earlier = to_toml(one);
  earlier.erase(earlier.find("\nbody_fluid_share = "), std::string("\nbody_fluid_share = 0.3").size());
  EXPECT_TRUE(same(parse_parameters(earlier, "earlier.toml"), one));
  const Parameters own = apply_overrides(one, {"contact.body_fluid_share=0.03"});
  EXPECT_EQ(own.contact.fluid_share, 0.3);
  EXPECT_NE(values_text(own).find("contact.body_fluid_share = 0.03\n"), std::string::npos);
}

TEST(Write, PresetsAreGoodAndDiffer) {
  Parameters adaptive;
  adaptive.run.integrator = Integrator::adaptive;
  adaptive.run.time_step = usual_time_step(Integrator::adaptive);
  EXPECT_TRUE(same(parameters_of(*find_preset("baseline")), adaptive));
  EXPECT_EQ(parameters_of(*find_preset("soft")).ecm.youngs_modulus, 0.05);
  EXPECT_EQ(parameters_of(*find_preset("stiff")).ecm.youngs_modulus, 0.4);
  EXPECT_EQ(find_preset("none"), nullptr);
}

TEST(Write, AScenarioReadsBackAsItsPreset) {
  for (const std::span<const Preset> all : {presets(), published_laws()})
    for (const Preset& preset : all)
      EXPECT_TRUE(same(parse_parameters(new_scenario(preset, "s.json"), "f.toml"), parameters_of(preset)))
          << preset.name;
}

/// The comment above each value of a file says where it is from, or that it is assumed; formulas of laws need none.
/// Only what `may_differ` tells of the section and the key differs from the baseline. How many values there are.
std::size_t sourced_values(const Template& file, const std::function<bool(const std::string&)>& may_differ) {
  const std::regex source(R"([A-Z][A-Za-z-]+( et al\.| and [A-Z][a-z]+)? (19|20)\d\d\b|\bassumed\b)");
  std::istringstream lines{std::string(file.text)};
  std::string section;
  std::string comment; // that of the values below it, up to the next one or an empty line
  bool has_value = false;
  std::size_t values = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find(" = ");
    if (line.starts_with("#")) {
      comment = has_value ? line : comment + line;
      has_value = false;
    } else if (equals == std::string::npos) {
      comment.clear();
      if (line.starts_with("[")) section = line.substr(1, line.size() - 2);
    } else if (has_value = true; section != "run" && section != "laws") { // whose integrator is numerics
      EXPECT_TRUE(std::regex_search(comment, source)) << file.name << ": " << line;
      EXPECT_TRUE(may_differ(section + "." + line.substr(0, equals))) << file.name << ": " << line;
      ++values;
    }
  }
  return values;
}

TEST(Write, EachValueOfATemplateHasItsSource) { // only what a lab can measure may differ, no closure
  const std::set<std::string> measured{"ecm.youngs_modulus",     "ecm.poissons_ratio",         "ecm.viscosity",
                                       "fibres.arrangement",     "fibres.direction_deg",       "fibres.stiffness",
                                       "fibres.onset",           "fibres.stiffening_strain",   "cell.radius",
                                       "cell.particles",         "actomyosin.force",           "protrusion.number",
                                       "protrusion.growth_time", "protrusion.initiation_rate", "adhesion.r_off_min"};
  for (const Template& file : templates()) {
    EXPECT_GE(sourced_values(file, [&](const std::string& key) { return measured.contains(key); }), 2U) << file.name;
    EXPECT_EQ(std::string(file.text), committed(fmt::format("scenarios/templates/{}.toml", file.name)));
  }
}

TEST(Write, EachConstantOfAPublishedLawHasItsSource) {
  ASSERT_EQ(law_files().size(), published_laws().size());
  for (const Template& file : law_files()) {
    const auto of_gel = [](const std::string& key) {
      return key.starts_with("laws.constants.") || key.starts_with("ecm.") || key.starts_with("fibres.");
    };
    EXPECT_GE(sourced_values(file, of_gel), 1U) << file.name;
    EXPECT_TRUE(std::regex_search(std::string(file.text), std::regex(R"(\n# [A-Z].* (19|20)\d\d, .*, doi:10\..*\n)")))
        << file.name << " names its paper";
    const Parameters p = parse_parameters(file.text, std::string(file.name));
    EXPECT_FALSE(changed_laws(p).empty()) << file.name;
    EXPECT_TRUE(law_notes(p).empty()) << file.name << ": " << law_notes(p).front();
    for (const Row* law : changed_laws(p)) EXPECT_EQ(fault_of_law_values(p, *law), "") << file.name;
    EXPECT_EQ(std::string(file.text), committed(fmt::format("scenarios/laws/{}.toml", file.name)));
  }
}

TEST(Write, AScenarioShowsEveryParameterAndHidesNumerics) {
  const std::string text = new_scenario(presets()[0], "some/schema.json");
  EXPECT_TRUE(text.starts_with("#:schema some/schema.json\n")) << "editors look for it in the first line";
  for (const Row& row : schema()) {
    const std::string key(key_of(row)); // those of fields stand in other sections, too
    if (kind(row) == Kind::field) {
      EXPECT_NE(text.find("\n# " + key + " = \"\"\n"), std::string::npos) << row.path;
      continue;
    }
    if (kind(row) == Kind::constants) {
      EXPECT_NE(text.find("\n# [laws.constants]\n# F_c = "), std::string::npos);
      continue;
    }
    const bool open = text.find("\n" + key + " = ") != std::string::npos;
    const bool hidden = text.find("\n# " + key + " = ") != std::string::npos;
    EXPECT_TRUE(open || hidden) << row.path;
    const bool follows = row.path == "run.time_step";             // the integrator
    const bool elsewhere = row.path.starts_with("contact.cells.") // "range" stands in [contact], too
                           || row.path.starts_with("nucleus.")    // and "radius" in [cell]
                           || row.path.starts_with("laws.");      // and "initiation_rate" in [protrusion]
    if (!elsewhere) {
      EXPECT_EQ(open, row.audience == Audience::usual && !follows) << row.path;
    }
  }
}

TEST(Write, TheSchemaForEditorsDescribesEveryParameter) {
  const auto schema_json = nlohmann::json::parse(json_schema());
  for (const Row& row : schema()) {
    std::string path(section_of(row));
    std::ranges::replace(path, '.', '/');
    for (std::size_t slash = path.find('/'); slash != std::string::npos; slash = path.find('/', slash + 12))
      path.replace(slash, 1, "/properties/");
    const auto& section = schema_json.at(nlohmann::json::json_pointer("/properties/" + path));
    EXPECT_FALSE(section.at("additionalProperties").get<bool>());
    const auto& property = section.at("properties").at(std::string(key_of(row)));
    EXPECT_TRUE(property.contains("default")) << row.path;
    EXPECT_EQ(property.contains("anyOf"), kind(row) == Kind::quantity || kind(row) == Kind::angle) << row.path;
  }
  const auto& E = schema_json.at("properties").at("ecm").at("properties").at("youngs_modulus");
  EXPECT_EQ(E.at("anyOf").at(1).at("exclusiveMinimum"), 0.0);
  EXPECT_EQ(E.at("anyOf").at(1).at("maximum"), 1e7);
}

TEST(Write, TheSchemaForEditorsTakesEveryValueThatIsWritten) {
  const auto schema_json = nlohmann::json::parse(json_schema());
  const auto pattern_of = [&](std::string_view section, std::string_view key) {
    std::string path = "/properties/";
    for (const char c : section) path += c == '.' ? std::string("/properties/") : std::string(1, c);
    const auto& any =
        schema_json.at(nlohmann::json::json_pointer(path)).at("properties").at(std::string(key)).at("anyOf");
    return std::regex(any.at(0).at("pattern").get<std::string>());
  };
  const std::regex pattern = pattern_of("adhesion", "zeta_diss");
  for (const char* good :
       {"20 1/nN", "0.1 1/s", "200 Pa", "-.15 1/um", "6 h 30 min", "5 µm", "30°", "1e-3 N/m", "1.4 N/m^1.5"})
    EXPECT_TRUE(std::regex_match(good, pattern)) << good;
  for (const char* bad : {"200", "0,2 kPa", "Pa", "20 1", "", "1 2 Pa"})
    EXPECT_FALSE(std::regex_match(bad, pattern)) << bad;
  for (const Row& row : schema()) {
    if (kind(row) != Kind::quantity) continue;
    const std::string text = value_text(row, {});
    EXPECT_TRUE(std::regex_match(text.substr(1, text.size() - 2), pattern_of(section_of(row), key_of(row))))
        << row.path;
  }
}

TEST(Write, CommittedDocumentsAreCurrent) {
  EXPECT_EQ(committed("docs/parameters.md"), parameters_markdown())
      << "bring it up to date with: matrigrate list --parameters > docs/parameters.md";
  EXPECT_EQ(committed("docs/scenario.schema.json"), json_schema())
      << "bring it up to date with: matrigrate list --schema-json > docs/scenario.schema.json";
}

TEST(Write, CommittedScenarioIsCurrent) {
  EXPECT_EQ(committed("scenarios/baseline.toml"), new_scenario(presets().front(), "../docs/scenario.schema.json"))
      << "bring it up to date with: rm scenarios/baseline.toml; matrigrate new scenarios/baseline.toml --schema "
         "../docs/scenario.schema.json";
}

} // namespace
} // namespace matrigrate
