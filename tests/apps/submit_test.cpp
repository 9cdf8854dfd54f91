#include "program.hpp"

#include <nlohmann/json.hpp>

#include <string_view>

namespace matrigrate {
namespace {

using nlohmann::json;

/// Studies that are handed to a sbatch of the test's own, which notes the words that it is given.
class Submit : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("e.toml", study);
    std::filesystem::create_directory(base / "bin");
    std::ofstream(base / "bin/sbatch") << "#!/bin/sh\nprintf '<%s>\\n' \"$@\" >'" << (base / "words").string()
                                       << "'\necho 4711\n";
    std::filesystem::permissions(base / "bin/sbatch", std::filesystem::perms::owner_all);
  }

  /// @param arguments  behind `study submit`, as a shell takes them
  Ended submit(const std::string& arguments, const std::string& path = "") const {
    const std::string search = path.empty() ? (base / "bin").string() + ":/usr/bin:/bin" : path;
    std::ofstream(base / "submit") << "cd '" << folder.string() << "' && PATH='" << search
                                   << "' exec '" MATRIGRATE_PROGRAM "' study submit " << arguments << "\n";
    const std::string command = "bash '" + (base / "submit").string() + "' >'" + (base / "out").string() + "' 2>'"
                                + (base / "err").string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(base / "out"), text_of(base / "err")};
  }

  std::string script(const std::string& name = "e-study") const { return text_of(folder / name / "submit.sh"); }
  std::string words() const { return text_of(base / "words"); }

  static constexpr const char* study = "preset = \"baseline\"\nreplicates = 2\n[sweep]\n"
                                       "ecm.youngs_modulus = [\"50 Pa\", \"100 Pa\"]\n";
};

TEST_F(Submit, WritesAScriptOfAJobArrayAndHandsItOver) {
  const Ended ended = submit("e.toml --throttle 2 --json");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(json::parse(ended.out).at("job"), "4711");
  EXPECT_EQ(json::parse(ended.out).at("tasks"), 4);
  for (const char* line : {"#SBATCH --array=0-3%2\n", "#SBATCH --requeue\n", "#SBATCH --cpus-per-task=1\n"})
    EXPECT_TRUE(contains(script(), line)) << script();
  for (const char* option : {"--account", "--qos", "--mem", "--mail", "--time", "--partition"})
    EXPECT_FALSE(contains(script(), option)) << "left to the cluster";
  EXPECT_EQ(words(), "<--requeue>\n<--parsable>\n<" + (folder / "e-study/submit.sh").string() + ">\n");
}

TEST_F(Submit, PassesOnWhatAClusterAsksFor) {
  const Ended ended = submit("e.toml --account lab_7 --partition short,long --qos high --mem 500M --time 1-12:30 "
                             "--mail-user a.b+c@uni.example --cpus 2");
  ASSERT_EQ(ended.code, 0) << ended.err;
  for (const char* line : {"--account=lab_7", "--partition=short,long", "--qos=high", "--mem=500M", "--time=1-12:30",
                           "--mail-user=a.b+c@uni.example", "--mail-type=END,FAIL", "--cpus-per-task=2"})
    EXPECT_TRUE(contains(script(), std::string("#SBATCH ") + line + "\n")) << line << '\n' << script();
}

TEST_F(Submit, HandsOnWhatStandsBehindTheDashes) {
  const Ended ended =
      submit("e.toml --json -- --constraint=avx2 -A lab --comment='two words, $HOME and '\\''quotes'\\'");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(words(), "<--requeue>\n<--parsable>\n<--constraint=avx2>\n<-A>\n<lab>\n"
                     "<--comment=two words, $HOME and 'quotes'>\n<"
                         + (folder / "e-study/submit.sh").string() + ">\n");
  const std::string said = "sbatch --requeue --parsable --constraint=avx2 -A lab '--comment=two words, $HOME and '\\''"
                           "quotes'\\''' ";
  EXPECT_TRUE(contains(script(), "\n# submitted by: " + said + "submit.sh\n")) << script();
  const Ended without = submit("e.toml -o other -- --constraint=avx2 --comment='two words'", "/nowhere");
  EXPECT_EQ(without.code, 5);
  EXPECT_TRUE(contains(without.err, "sbatch --requeue --parsable --constraint=avx2 '--comment=two words' "
                                        + (folder / "other/submit.sh").string()))
      << without.err;
}

TEST_F(Submit, RefusesWhatSlurmWouldMisread) {
  const Ended ended = submit("e.toml --account 'a b' --partition $'p\\ntouch PWNED' --qos '\"' --mem '4 GB' "
                             "--time '12 h' --mail-user 'a;b' -- $'--comment=x\\ny'");
  EXPECT_EQ(ended.code, 3) << ended.out << ended.err;
  for (const char* option : {"--account: \"a b\"", "--partition: \"p?touch PWNED\"", "--qos: \"\"\"", "--mem: \"4 GB\"",
                             "--time: \"12 h\"", "--mail-user: \"a;b\"", "--: \"--comment=x?y\""})
    EXPECT_TRUE(contains(ended.err, option)) << option << '\n' << ended.err;
  EXPECT_TRUE(contains(ended.err, "as in 12:00:00")) << ended.err;
  for (const char* stray : {"e.toml -- job.sh", "e.toml more.toml"}) EXPECT_EQ(submit(stray).code, 3) << stray;
  EXPECT_EQ(submit("e.toml --cpus 0").code, 2);
  EXPECT_EQ(submit("e.toml --account " + std::string(100000, 'a') + "/").code, 3);
  EXPECT_EQ(entries(), 1U) << "nothing is written";
  EXPECT_EQ(words(), "");
}

TEST_F(Submit, KnowsSlurmsTimes) {
  for (const char* good : {"5", "90", "5:00", "12:00:00", "2-0", "2-12", "1-0:30", "1-12:30:15", "0", "UNLIMITED"})
    EXPECT_EQ(submit(std::string("e.toml --time ") + good).code, 0) << good;
  for (const char* bad : {"4", "4:59", "0:04:59", "x", "1h", "1-", "-1", "1:2:3:4", "1-2:3:4:5", "5.5", "12:00:00 "}) {
    const Ended ended = submit("e.toml -o bad --time='" + std::string(bad) + "'");
    EXPECT_EQ(ended.code, 3) << bad;
    EXPECT_TRUE(contains(ended.err, "--time: \"" + std::string(bad) + "\"")) << ended.err;
  }
  EXPECT_FALSE(exists("bad"));
}

TEST_F(Submit, NamesOfFoldersAreNoCommands) {
  for (const std::string name : {"new\ntouch PWNED\n", "tab\t", "say \"hi\"", "back\\slash", "bell\a"}) {
    write(name + ".toml", study);
    std::string word;
    for (const char c : name) word += c == '\'' ? "'\\''" : std::string(1, c);
    const Ended ended = submit("'" + word + ".toml'");
    EXPECT_EQ(ended.code, 3) << ended.err;
    EXPECT_TRUE(contains(ended.err, "choose another folder")) << ended.err;
    EXPECT_FALSE(exists(name + "-study"));
    EXPECT_EQ(submit("'" + word + ".toml' -o plain").code, 0) << "the name of the study's file alone does no harm";
  }
  EXPECT_FALSE(exists("PWNED"));
  ASSERT_EQ(submit("e.toml -o '100 %A $(touch PWNED) `touch PWNED` '\\''x'\\'").code, 0);
  const std::string odd = "100 %A $(touch PWNED) `touch PWNED` 'x'";
  EXPECT_TRUE(contains(script(odd), "/100 %%A $(touch PWNED) `touch PWNED` 'x'/slurm/%A_%a.out\"\n")) << script(odd);
  std::ofstream(base / "print_folder")
      << "cd '" << folder.string() << "'\n"
      << "sed -i 's/^\"${program\\[@\\]}\".*/printf %s \"$folder\" \\&/' 100*/submit.sh\n"
      << "SLURM_ARRAY_TASK_ID=0 bash 100*/submit.sh\n";
  std::system(("bash '" + (base / "print_folder").string() + "' >'" + (base / "printed").string() + "'").c_str());
  EXPECT_EQ(text_of(base / "printed"), (folder / odd).string());
  EXPECT_FALSE(exists("PWNED"));
}

/// A task of the script calls the launcher with its words, and then the words of the task.
TEST_F(Submit, CallsALauncherInPlaceOfThisProgram) {
  std::filesystem::create_directory(base / "my bin");
  std::ofstream(base / "my bin/launch") << "#!/bin/sh\nprintf '<%s>\\n' \"$@\" >'" << (base / "launched").string()
                                        << "'\n";
  std::filesystem::permissions(base / "my bin/launch", std::filesystem::perms::owner_all);
  const std::string launcher = "\"" + (base / "my bin/launch").string() + "\" exec \"$(touch PWNED) x.sif\" matrigrate";
  const Ended ended = submit("e.toml --launcher '" + launcher + "'");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_FALSE(contains(script(), MATRIGRATE_PROGRAM)) << "nodes may not have it";
  const std::string task =
      "cd '" + base.string() + "' && SLURM_ARRAY_TASK_ID=3 bash '" + (folder / "e-study/submit.sh").string() + "'";
  EXPECT_EQ(std::system(task.c_str()), 0);
  const std::string said = text_of(base / "launched");
  EXPECT_TRUE(said.starts_with("<exec>\n<$(touch PWNED) x.sif>\n<matrigrate>\n<study>\n<task>\n<"
                               + (folder / "e-study").string() + ">\n<3>\n<--list>\n<slurm/tasks-"))
      << said;
  EXPECT_FALSE(std::filesystem::exists(base / "PWNED"));
  EXPECT_EQ(submit("e.toml -o none --launcher ''").code, 2);
  const Ended refused = submit("e.toml -o none --launcher $'x\ay'");
  EXPECT_EQ(refused.code, 3);
  EXPECT_TRUE(contains(refused.err, "--launcher: \"x?y\" holds a control character")) << refused.err;
  EXPECT_FALSE(exists("none"));
}

TEST_F(Submit, NamesThatAreNoTextAreNoInternalError) {
  const std::string name = "bad\xff\xfe name";
  write(name + ".toml", study);
  const Ended ended = submit("'" + name + ".toml' --json");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(json::parse(ended.out).at("folder"), "bad\xef\xbf\xbd\xef\xbf\xbd name-study");
}

} // namespace
} // namespace matrigrate
