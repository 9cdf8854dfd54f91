#include "program.hpp"

#include <cstddef>
#include <string>
#include <utility>

namespace matrigrate {
namespace {

std::string lines(const std::string& text, int n) {
  std::size_t end = 0;
  for (int i = 0; i < n && end != std::string::npos; ++i) end = text.find('\n', end) + 1;
  return text.substr(0, end);
}

TEST_F(Program, WithoutAVerbItNamesThem) {
  const Ended bare = run("");
  EXPECT_EQ(bare.code, 2);
  EXPECT_EQ(lines(bare.err, 1), "matrigrate: a verb is required\n");
  EXPECT_TRUE(contains(bare.err, "\nThe verbs are: new, check, explain, run, resume, ")) << bare.err;
  EXPECT_EQ(lines(bare.err, 2), bare.err) << "two lines";
  const Ended study = run("study");
  EXPECT_EQ(study.code, 2);
  EXPECT_EQ(lines(study.err, 1), "matrigrate: a verb of study is required\n");
  EXPECT_TRUE(contains(study.err, "\nThe verbs of study are: plan, run, ")) << study.err;
  EXPECT_FALSE(contains(run("--quiet").err, "subcommand")) << "one word for one thing";
  EXPECT_FALSE(contains(run("-h").out, "SUBCOMMAND"));
  EXPECT_TRUE(contains(run("-h").out, "\nVerbs:\n  new "));
  EXPECT_TRUE(contains(run("-h").out, "\nMore verbs:\n  demo "));
  EXPECT_TRUE(contains(run("study -h").out, "\nVerbs:\n"));
}

TEST_F(Program, OptionsThatWantANumberSayWhich) {
  ASSERT_EQ(run("new cell.toml").code, 0);
  const std::string seeds = "is no whole number; allowed is >= 0 and <= 9007199254740991, such as 1\n";
  EXPECT_EQ(run("run cell.toml --seed abc").err, "--seed: run.seed: \"abc\" " + seeds);
  EXPECT_EQ(run("explain cell.toml --set run.seed=abc").err, "--set: run.seed: \"abc\" " + seeds);
  EXPECT_EQ(run("sample run.seed=abc").err, "run.seed: \"abc\" " + seeds);
  EXPECT_EQ(run("explain cell.toml --set ecm.poissons_ratio=abc").err,
            "--set: ecm.poissons_ratio: \"abc\" is no number; allowed is > 0 and < 0.5, such as 0.45\n");
  for (const auto& [words, said] : {
           std::pair{"run cell.toml --threads abc", "--threads: \"abc\" is not a whole number from 0 to 1024"},
           {"resume here --threads -1", "--threads: \"-1\" is not a whole number from 0 to 1024"},
           {"sample --threads 1.5", "--threads: \"1.5\" is not a whole number from 0 to 1024"},
           {"study run s.toml --jobs 0", "--jobs: \"0\" is not a whole number from 1 to 4096"},
           {"study submit s.toml --chunk x", "--chunk: \"x\" is not a whole number from 0 to 100000"},
           {"study submit s.toml --throttle -1", "--throttle: \"-1\" is not a whole number from 0 to 100000"},
           {"study task e-study -1 --list l", "INDEX: \"-1\" is not a whole number from 0 to 100000"},
           {"reproduce A1 --replicates x", "--replicates: \"x\" is not a whole number from 1 to 100000"},
           {"export r --movie --seconds x", "--seconds: \"x\" is not a number from 0.1 to 3600"},
           {"tracks t.csv --shortest x", "--shortest: \"x\" is not a whole number from 0 to 100000"},
           {"tracks t.csv --fewest -1", "--fewest: \"-1\" is not a whole number from 0 to 100000"},
           {"tracks t.csv --jitter x", "--jitter: \"x\" is not a number"},
           {"demo --hours x", "--hours: \"x\" is not a number"},
       }) {
    const Ended ended = run(words);
    EXPECT_EQ(ended.code, 2) << words;
    EXPECT_EQ(lines(ended.err, 1), std::string("matrigrate: ") + said + "\n") << words;
  }
}

TEST_F(Program, AVerbOfAnotherGroupIsNamed) {
  const Ended report = run("study report e-study");
  EXPECT_EQ(report.code, 2);
  EXPECT_EQ(lines(report.err, 1), "matrigrate: study has no verb \"report\"; did you mean matrigrate report?\n");
  EXPECT_TRUE(contains(run("study colect x").err, "study has no verb \"colect\"; did you mean collect?"));
}

TEST_F(Program, AnUnknownOptionIsNamedWithTheNearest) {
  const Ended hour = run("run cell.toml --hour 2");
  EXPECT_EQ(hour.code, 2);
  EXPECT_EQ(lines(hour.err, 1), "matrigrate: there is no option --hour; did you mean --hours?\n");
  EXPECT_TRUE(contains(run("study plan e.toml --jbos=3").err, "there is no option --jbos; did you mean --jobs?"));
  EXPECT_TRUE(contains(run("check --jsn").err, "there is no option --jsn; did you mean --json?"));
  const Ended many = run("explain a b c");
  EXPECT_EQ(many.code, 2);
  EXPECT_EQ(lines(many.err, 1), "matrigrate: too many arguments: b c\n") << "in the order typed";
}

TEST_F(Program, ALongWrongNumberIsAWrongNumber) {
  const Ended ended = run("run x.toml --threads " + std::string(60'000, '9'));
  EXPECT_EQ(ended.code, 2);
  EXPECT_LT(ended.err.size(), 2000U);
}

TEST_F(Program, TimesAndSeedsOfOptionsAreSaidAsOfFiles) {
  write("cell.toml", "[ecm]\nradius = \"60 um\"\n");
  EXPECT_EQ(run("run cell.toml --seed -3").err,
            "--seed: run.seed: -3 is out of range; allowed is >= 0 and <= 9007199254740991\n");
  EXPECT_TRUE(contains(run("run cell.toml --seed 18446744073709551616").err,
                       "--seed: run.seed: 18446744073709551616 is out of range"));
  EXPECT_TRUE(contains(run("run cell.toml --hours 1kPa").err, "--hours: run.duration: "));
  EXPECT_TRUE(contains(run("run cell.toml --seed 1 --seed 2").err, "--seed is given 2 times\n"));
  for (const char* six_seconds : {"6s", "'6 s'", "'0.1 min'", "0.00166666666666666667"}) {
    const Ended ended = run(std::string("run cell.toml --quiet -o here --force --hours ") + six_seconds);
    EXPECT_EQ(ended.code, 0) << six_seconds << ended.err;
    EXPECT_TRUE(contains(text_of(folder / "here/scenario.resolved.toml"), "duration = \"6 s\"")) << six_seconds;
  }
}

TEST_F(Program, AFileOfTheWrongKindIsToldOnce) {
  write("cell.toml", "[ecm]\nradius = \"60 um\"\n[cell]\nradius = \"15 um\"\n");
  const Ended study = run("study plan cell.toml");
  EXPECT_EQ(study.code, 3);
  EXPECT_EQ(lines(study.err, 1), study.err) << "one line";
  EXPECT_TRUE(contains(study.err, "is a scenario of one run, and not a study; matrigrate run cell.toml")) << study.err;
  for (const char* verb : {"run", "check", "explain"}) {
    const Ended preset = run(std::string(verb) + " baseline");
    EXPECT_EQ(preset.code, 5) << verb;
    EXPECT_TRUE(contains(preset.err, "matrigrate new baseline.toml --preset baseline")) << preset.err;
  }
}

TEST_F(Program, CheckTakesChanges) {
  write("cell.toml", "[ecm]\nradius = \"60 um\"\n");
  EXPECT_EQ(run("check cell.toml --set ecm.radius='90 um'").code, 0);
  const Ended bad = run("check cell.toml --set ecm.radius='1 um'");
  EXPECT_EQ(bad.code, 3);
  EXPECT_TRUE(contains(bad.err, "--set: ecm.radius: ")) << bad.err;
}

TEST_F(Program, ExplainTellsTheMeanDirectionOfAField) {
  const std::string fibres = "[ecm]\nradius = \"60 um\"\n[fibres]\narrangement = \"uniaxial\"\ndirection_deg = 0\n";
  write("even.toml", fibres + "[fibres.field]\ndirection_deg = \"60\"\n");
  EXPECT_TRUE(contains(run("explain even.toml").out, "mean direction 60 degrees over the particles"));
  write("across.toml", fibres + "[fibres.field]\ndirection_deg = \"x < 0 ? 80 : -80\"\n"); // both sides of 90
  EXPECT_TRUE(contains(run("explain across.toml").out, "mean direction 90")) << "not 0";
  write("round.toml", fibres + "[fibres.field]\ndirection_deg = \"atan2(x, -y)*180/_pi\"\n");
  EXPECT_TRUE(contains(run("explain round.toml").out, "no mean direction over the particles"));
}

} // namespace
} // namespace matrigrate
