#include "program.hpp"

#include <cstddef>

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
  EXPECT_TRUE(contains(bare.err, "\nThe verbs are: new, list, check, explain, run, ")) << bare.err;
  EXPECT_EQ(lines(bare.err, 2), bare.err) << "two lines";
  const Ended study = run("study");
  EXPECT_EQ(study.code, 2);
  EXPECT_EQ(lines(study.err, 1), "matrigrate: a verb of study is required\n");
  EXPECT_TRUE(contains(study.err, "\nThe verbs of study are: plan, run, ")) << study.err;
  EXPECT_FALSE(contains(run("--quiet").err, "subcommand")) << "one word for one thing";
  EXPECT_FALSE(contains(run("-h").out, "SUBCOMMAND"));
  EXPECT_TRUE(contains(run("-h").out, "\nVerbs:\n"));
  EXPECT_TRUE(contains(run("study -h").out, "\nVerbs:\n"));
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

} // namespace
} // namespace matrigrate
