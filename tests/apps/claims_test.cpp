#include "program.hpp"

#include <nlohmann/json.hpp>

namespace matrigrate {
namespace {

using nlohmann::json;

/// A claim of the user's own about a cell in a small disc.
class Claims : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"0.002 h\"\n[protrusion]\ninitiation_rate = \"0.01 "
                    "1/s\"\n");
  }

  void write_study(const std::string& name, const std::string& conditions) const {
    write(name + ".toml", "scenario = \"s.toml\"\nreplicates = 2\nreadouts = [\"n_protrusions\"]\n"
                          "[[points]]\nlabel = \"soft\"\necm.youngs_modulus = \"50 Pa\"\n"
                          "[[points]]\nlabel = \"stiff\"\necm.youngs_modulus = \"400 Pa\"\n"
                          "[[claims]]\nid = \"S1\"\nkind = \"experiment\"\nsentence = \"as it is\"\n"
                          "published = \"2, or 3\"\nconditions = [\n"
                              + conditions + "]\n");
  }

  std::string file(const std::string& name) const { return text_of(folder / name); }
};

const std::string among_few = R"({ rule = "within", readout = "n_protrusions", at = "soft", low = 0, high = 1000 },)";

TEST_F(Claims, OfAStudyAreJudgedWithIt) {
  write_study("own", among_few);
  const Ended ended = run("study run own.toml --quiet");
  EXPECT_EQ(ended.code, 0) << ended.err;
  const std::string table = file("own-study/claims.csv");
  EXPECT_TRUE(table.starts_with("id,kind,claim,published,ours,verdict,")) << table;
  EXPECT_TRUE(contains(table, "\nS1,experiment,as it is,\"2, or 3\",")) << table;
  EXPECT_TRUE(table.ends_with(",holds,,,,\n")) << table;
  EXPECT_TRUE(contains(file("own-study/study.resolved.toml"), "[[claims]]"));
  const json claim = json::parse(page_data("own-study/report.html")).at("claims").at(0);
  EXPECT_EQ(claim.at("id"), "S1");
  EXPECT_EQ(claim.at("verdict"), "holds");
  EXPECT_EQ(claim.at("caveat"), "");
  const Ended collected = run("study collect own-study");
  EXPECT_TRUE(contains(collected.out, "S1   experiment  holds")) << collected.out;
  EXPECT_TRUE(contains(collected.out, "1 of 1 hold.\n")) << collected.out;
  EXPECT_TRUE(contains(run("study collect own-study --json").out, "\"claims.csv\""));
  EXPECT_EQ(file("own-study/claims.csv"), table) << "from the folder alone";
}

TEST_F(Claims, TellWhichWayMeansLeanWhereRunsEndedAtTheRim) {
  const std::string claim = "\nkind = \"experiment\"\nsentence = \"as it is\"\npublished = \"few\"\nconditions = [";
  const std::string condition = R"({ rule = "within", readout = "n_protrusions", low = 0, high = 1000, at = )";
  write("own.toml", "scenario = \"s.toml\"\nreplicates = 2\n[set]\nrun.duration = \"0.1 h\"\n"
                    "[[points]]\nlabel = \"fast\"\nprotrusion.number = 1\n"
                    "[[points]]\nlabel = \"still\"\nprotrusion.initiation_rate = \"0 1/s\"\n"
                    "[[claims]]\nid = \"S1\""
                        + claim + condition + "\"fast\" }]\n[[claims]]\nid = \"S2\"" + claim + condition
                        + "\"still\" }]\n");
  const Ended ended = run("study run own.toml --quiet");
  EXPECT_EQ(ended.code, 4) << ended.err;
  const std::string caveat = "2 of 2 runs ended at the rim: means are of the slower cells";
  const json claims = json::parse(page_data("own-study/report.html")).at("claims");
  EXPECT_EQ(claims.at(0).at("caveat"), caveat);
  EXPECT_EQ(claims.at(1).at("caveat"), "");
  EXPECT_TRUE(contains(file("own-study/claims.csv"), "," + caveat + "\n")) << file("own-study/claims.csv");
  const Ended collected = run("study collect own-study");
  EXPECT_TRUE(contains(collected.out, "(" + caveat + ")")) << collected.out;
}

TEST_F(Claims, AreCheckedBeforeAnythingIsWritten) {
  write_study("own",
              R"({ rule = "same", readout = "n_protrusion", from = "sof", to = "stiffness: youngs_modulus 51 Pa" },
{ rule = "rises", readout = "n_protrusions" },
{ rule = "above", readout = "n_protrusions", at = "soft" },
)");
  for (const char* verb : {"check", "study plan", "study run"}) {
    const Ended ended = run(std::string(verb) + " own.toml");
    const std::string told = ended.out + ended.err;
    EXPECT_EQ(ended.code, 3) << verb;
    EXPECT_TRUE(contains(told, "own.toml:16:28: claims.conditions.readout: \"n_protrusion\" is not known")) << told;
    EXPECT_TRUE(contains(told, "did you mean n_protrusions?")) << told;
    EXPECT_TRUE(contains(told,
                         "own.toml:16:51: claims.conditions.from: \"sof\" is not the label of a point; the labels "
                         "are \"soft\", \"stiff\"; did you mean soft?"))
        << told;
    EXPECT_TRUE(contains(told, "did you mean stiffness: youngs_modulus 50 Pa?")) << told;
    EXPECT_TRUE(contains(told, "own.toml:17:10: claims.conditions.rule: \"rises\" is not known")) << told;
    EXPECT_TRUE(
        contains(told, "own.toml:18:1: claims.conditions.bound: is missing; \"above\" needs readout, at, bound"))
        << told;
  }
  EXPECT_EQ(entries(), 2U);
}

TEST_F(Claims, MayNeedAStudyBesideTheirOwn) {
  write_study("own", R"({ rule = "within", readout = "n_protrusions", at = "other: stiff", low = 0, high = 1000 },)");
  EXPECT_TRUE(contains(run("study plan own.toml").err, "\"other: stiff\" is not the label of a point"));
  write_study("other", among_few);
  EXPECT_EQ(run("check own.toml").code, 0);
  EXPECT_EQ(run("study run own.toml --quiet").code, 0);
  EXPECT_TRUE(contains(file("own-study/claims.csv"), "undecided")) << "the other was not run";
  EXPECT_EQ(run("study run other.toml --quiet").code, 0);
  EXPECT_EQ(run("study collect own-study --quiet").code, 0);
  EXPECT_TRUE(contains(file("own-study/claims.csv"), ",holds,,,,\n")) << file("own-study/claims.csv");
}

} // namespace
} // namespace matrigrate
