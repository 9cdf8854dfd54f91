#include "studies.hpp"

#include <gtest/gtest.h>

namespace matrigrate::study {
namespace {

const std::string points = "[sweep]\necm.youngs_modulus = [\"50 Pa\", \"200 Pa\"]\n[[conditions]]\nlabel = \"one\"\n"
                           "protrusion.number = 1\n[[conditions]]\nlabel = \"two\"\nprotrusion.number = 2\n";
const std::string head = "id = \"A1\"\nkind = \"predicted\"\nsentence = \"it is so\"\n";

std::string claim(const std::string& condition) {
  return points + "[[claims]]\n" + head + "conditions = [" + condition + "]\n";
}

/// The only fault of a condition, from its key on, where a study "other" is known; otherwise all of them.
std::string fault_in(const std::string& condition) {
  Changes changes;
  changes.labels_of = [](const std::string& name) {
    return name == "other" ? std::optional(std::vector<std::string>{"soft", "stiff"}) : std::nullopt;
  };
  try {
    parse_study("preset = \"baseline\"\nreplicates = 3\n" + claim(condition), "f.toml", ".", changes);
  } catch (const ConfigurationError& error) {
    const std::string fault = to_string(error.faults().front());
    return error.faults().size() == 1 ? fault.substr(fault.find("claims")) : error.what();
  }
  return {};
}

TEST(ReadClaims, TakesEveryKey) {
  const Study s = read(points + "[[claims]]\n" + head + R"(published = "3.7 um/h"
conditions = [
  { rule = "differs", readout = "f_mat", from = "one: youngs_modulus 50 Pa", to = ["two: youngs_modulus 50 Pa", "two: youngs_modulus 200 Pa"], sign = "down" },
  { rule = "within", readout = "l_prot_um", at = "one: youngs_modulus 50 Pa", low = 25, high = 30 },
  { rule = "mostly_up_to", readout = "n_simultaneous_max", bound = 3, share = 0.5, study = "other" },
  { rule = "agrees", readout = "n_protrusions", at = "other: any label", value = 5.6, runs = 18 },
])");
  ASSERT_EQ(s.claims.size(), 1U);
  const Claim& c = s.claims.front();
  EXPECT_EQ(c.id, "A1");
  EXPECT_EQ(c.kind, ClaimKind::predicted);
  EXPECT_EQ(c.published, "3.7 um/h");
  ASSERT_EQ(c.conditions.size(), 5U) << "one for each point of a list";
  EXPECT_EQ(c.conditions[1].from.label, "one: youngs_modulus 50 Pa") << "its own, although it has a colon";
  EXPECT_EQ(c.conditions[1].to.label, "two: youngs_modulus 200 Pa");
  EXPECT_EQ(c.conditions[1].sign, Sign::down);
  EXPECT_EQ(c.conditions[2].value, 25.0);
  EXPECT_EQ(c.conditions[2].high, 30.0);
  EXPECT_EQ(c.conditions[3].share, 0.5);
  EXPECT_EQ(c.conditions[4].to.study, "other");
  EXPECT_EQ(c.conditions[4].to.label, "any label");
  EXPECT_EQ(c.conditions[4].runs, 18.0);
  EXPECT_EQ(c.studies(), (std::vector<std::string>{"", "other"}));
  EXPECT_TRUE(c.depends_on("", "one: youngs_modulus 50 Pa"));
  EXPECT_TRUE(c.depends_on("", "two: youngs_modulus 50 Pa"));
  EXPECT_FALSE(c.depends_on("", "one: youngs_modulus 200 Pa")) << "no condition names it";
  EXPECT_TRUE(c.depends_on("other", "one: youngs_modulus 200 Pa")) << "a condition is on all runs of that study";
  EXPECT_FALSE(c.depends_on("third", "any label"));
}

/// Folders of studies hold claims as they were written then.
TEST(ReadClaims, OfEarlierVersionsAreThoseOfTheRulesOfToday) {
  const std::string conditions = R"(conditions = [
  { rule = "none_above", readout = "f_mat", bound = 1, edition = "first" },
  { rule = "mean_above", readout = "f_mat", bound = 0.5, edition = "second" },
  { rule = "mean_above", readout = "f_mat", bound = 0.4, edition = "both" },
]
)";
  const std::string before = points + "[[claims]]\n" + head;
  const Study s = read(before + "kind_with_first_closures = \"calibration\"\nclosures = \"second\"\n" + conditions);
  ASSERT_EQ(s.claims.size(), 1U);
  EXPECT_NE(fault_of("[[claims]]\n" + head
                     + "conditions = [{ rule = \"none_above\", readout = \"f_mat\", bound = 1, "
                       "edition = \"frist\" }]\n")
                .find("did you mean first?"),
            std::string::npos);
  EXPECT_EQ(s.claims[0].kind, ClaimKind::predicted);
  ASSERT_EQ(s.claims[0].conditions.size(), 2U);
  EXPECT_EQ(s.claims[0].conditions[0].value, 0.5);
  EXPECT_TRUE(fault_of("[[claims]]\n" + head + "closures = \"first\"\n" + conditions)
                  .ends_with("claims.closures: has gone with the first set of closures; the version of the tag "
                             "closures-2 has both"));
  EXPECT_EQ(fault_of("in_place_of = \"stiffness\"\n"),
            "f.toml:3:1: in_place_of: has gone with the first set of closures; the version of the tag closures-2 has "
            "both");
}

TEST(ReadClaims, StandInTheResolvedStudy) {
  const Study s =
      read(claim(R"({ rule = "above", readout = "f_mat", at = "one: youngs_modulus 50 Pa", bound = 0.5 })"));
  const std::string text = to_toml(s, "base.toml");
  const std::size_t at = text.find("[[claims]]");
  ASSERT_NE(at, std::string::npos) << text;
  const Study again = read(points + text.substr(at));
  ASSERT_EQ(again.claims.size(), 1U);
  EXPECT_EQ(again.claims[0].text, s.claims[0].text);
  EXPECT_EQ(again.claims[0].conditions[0].value, 0.5);
  EXPECT_EQ(again.claims[0].conditions[0].to.label, "one: youngs_modulus 50 Pa");
}

TEST(ReadClaims, TellsEachFaultOfAClaim) {
  EXPECT_EQ(fault_of("claims = 3\n"),
            "f.toml:3:10: claims: is no list of claims; write [[claims]] and an id, a sentence and conditions below");
  const std::vector<std::string> faults =
      faults_of("preset = \"baseline\"\nreplicates = 3\n[[claims]]\nkid = \"A\"\nkind = \"prediction\"\nid = \"\"\n"
                "conditions = []\n");
  ASSERT_EQ(faults.size(), 5U) << fmt::format("{}", fmt::join(faults, "\n"));
  EXPECT_EQ(faults[0],
            "f.toml:3:1: claims.sentence: is missing; write sentence = \"cells are faster in a stiff matrix\"");
  EXPECT_EQ(faults[1], "f.toml:4:1: claims.kid: there is no such key; did you mean id?");
  EXPECT_EQ(faults[2],
            "f.toml:5:8: claims.kind: \"prediction\" is not known; allowed is \"calibration\" or \"predicted\" "
            "or \"verification\" or \"experiment\"; did you mean predicted?");
  EXPECT_EQ(faults[3], "f.toml:6:6: claims.id: is empty");
  EXPECT_EQ(faults[4], "f.toml:7:14: claims.conditions: is no list of conditions, each a table with a rule");
  const std::string good = R"(conditions = [{ rule = "mean_above", readout = "f_mat", bound = 0.5 }])";
  EXPECT_EQ(fault_of("[[claims]]\n" + head + good + "\n[[claims]]\n" + head + good + "\n"),
            "f.toml:9:6: claims.id: \"A1\" is the id of two claims");
}

TEST(ReadClaims, TellsEachFaultOfACondition) {
  EXPECT_EQ(fault_in(R"({ rule = "difers" })"),
            "claims.conditions.rule: \"difers\" is not known; allowed is \"differs\" or \"same\" or \"leans\" or "
            "\"msd_leans\" or \"not_beyond\" or \"ratio_below\" or \"exceeds\" or \"agrees\" or \"lowest_agrees\" or "
            "\"highest_agrees\" "
            "or \"within\" or \"below\" or \"above\" or \"correlates\" or \"uncorrelated\" or \"mean_above\" or "
            "\"none_above\" or \"mostly_up_to\"; did you mean differs?");
  EXPECT_EQ(fault_in("3"), "claims.conditions: is a number, but a table is expected");
  EXPECT_EQ(fault_in(R"({ readout = "f_mat" })"), "claims.conditions.rule: is missing; write rule = \"differs\"");
  EXPECT_EQ(fault_in(R"({ rule = "mean_above", readout = "f_mat" })"),
            "claims.conditions.bound: is missing; \"mean_above\" needs readout, bound");
  EXPECT_EQ(fault_in(R"({ rule = "mean_above", readout = "f_mat", bound = 1, sing = "up" })"),
            "claims.conditions.sing: \"mean_above\" has no such key; it has readout, bound, rule, study, of_edition");
  EXPECT_TRUE(fault_in(R"({ rule = "mean_above", readout = "f_mt", bound = 1 })").find("; did you mean f_mat? `")
              != std::string::npos);
  EXPECT_EQ(fault_in(R"({ rule = "correlates", readout = "f_mat", with = "l_prot_um", sign = "plus" })"),
            "claims.conditions.sign: \"plus\" is not known; allowed is \"up\" or \"down\"");
  EXPECT_EQ(fault_in(R"({ rule = "above", readout = "f_mat", at = "one: youngs_modulus 20 Pa", bound = 1 })"),
            "claims.conditions.at: \"one: youngs_modulus 20 Pa\" is not the label of a point; the labels are "
            "\"one: youngs_modulus 50 Pa\", \"two: youngs_modulus 50 Pa\", \"one: youngs_modulus 200 Pa\", "
            "\"two: youngs_modulus 200 Pa\"; did you mean one: youngs_modulus 50 Pa?");
  EXPECT_EQ(fault_in(R"({ rule = "same", readout = "f_mat", from = [], to = "one: youngs_modulus 50 Pa" })"),
            "claims.conditions.from: lists no point");
  EXPECT_EQ(fault_in(R"({ rule = "within", readout = "f_mat", at = "one: youngs_modulus 50 Pa", low = 2, high = 1 })"),
            "claims.conditions.low: is not below high");
  EXPECT_EQ(fault_in(R"({ rule = "mostly_up_to", readout = "f_mat", bound = 1, share = 50 })"),
            "claims.conditions.share: 50 is out of range; allowed is > 0 and <= 1");
  EXPECT_EQ(fault_in(R"({ rule = "lowest_agrees", readout = "f_mat", value = 1, runs = 0 })"),
            "claims.conditions.runs: 0 is out of range; allowed is >= 1 and <= 1000000");
  const std::string two = R"(["one: youngs_modulus 50 Pa", "two: youngs_modulus 50 Pa"])";
  const std::string three =
      R"(["one: youngs_modulus 50 Pa", "two: youngs_modulus 50 Pa", "one: youngs_modulus 200 Pa"])";
  EXPECT_EQ(fault_in(R"({ rule = "same", readout = "f_mat", from = )" + two + ", to = " + three + " }"),
            "claims.conditions.to: lists 3 points, but from lists 2; write as many, or one");
}

TEST(ReadClaims, KnowsThePointsOfOtherStudies) {
  EXPECT_EQ(fault_in(R"({ rule = "above", readout = "f_mat", at = "other: soft", bound = 1 })"), "");
  EXPECT_EQ(fault_in(R"({ rule = "above", readout = "f_mat", at = "other: sofd", bound = 1 })"),
            "claims.conditions.at: \"other: sofd\" is not the label of a point; the labels are \"other: soft\", "
            "\"other: stiff\"; did you mean other: soft?");
  EXPECT_TRUE(fault_in(R"({ rule = "above", readout = "f_mat", at = "none: soft", bound = 1 })")
                  .starts_with("claims.conditions.at: \"none: soft\" is not the label of a point"));
  EXPECT_EQ(fault_in(R"({ rule = "mean_above", readout = "f_mat", study = "none", bound = 1 })"),
            "claims.conditions.study: there is no none.toml beside this file, and no study none of `matrigrate list`");
}

} // namespace
} // namespace matrigrate::study
