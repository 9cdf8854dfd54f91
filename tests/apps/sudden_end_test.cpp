#include "apps/terminal/stop_signal.hpp"

#include "program.hpp"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>

namespace matrigrate {
namespace {

bool someone_else_handles_them() { // sanitizers
  struct sigaction action {};
  return ::sigaction(SIGSEGV, nullptr, &action) == 0 && action.sa_handler != SIG_DFL;
}

class SuddenEnd : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    if (someone_else_handles_them()) GTEST_SKIP() << "someone else handles these signals";
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[protrusion]\ninitiation_rate = \"0.001 1/s\"\n[output]\n"
                    "track_interval = \"4 s\"\ncheckpoint_interval = \"8 s\"\n"
                    "field_interval = \"8 s\"\n[run]\nduration = \"48 s\"\n");
  }

  /// The exit code of a run that got a signal after its second checkpoint.
  int told(const std::string& name, const std::string& signal) const {
    int code = 0;
    for (int attempt = 0; attempt < 20 && code == 0; ++attempt) { // on a busy machine it may be done before
      std::filesystem::remove_all(folder / name);
      code = stopped("run s.toml -o " + name + " --quiet", name + "/checkpoint_prev.h5", "kill -s " + signal + " $p");
    }
    return code;
  }
};

TEST_F(SuddenEnd, EndsWithACodeOfTheTableAndIsResumedToTheSameBits) {
  ASSERT_EQ(run("run s.toml -o whole --quiet").code, 0);
  for (const std::string signal : {"SEGV", "BUS", "FPE", "ILL", "ABRT"}) {
    EXPECT_EQ(told(signal, signal), 4) << signal;
    const std::string said = text_of(base / "err");
    EXPECT_TRUE(said.starts_with("matrigrate: ended by SIG" + signal + ": ")) << said;
    EXPECT_TRUE(contains(said, "The last checkpoint and the files up to it are good; matrigrate resume continues "
                               "from there"));
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
    const Ended again = run("resume " + signal + " --quiet");
    EXPECT_EQ(again.code, 0) << again.err;
    for (const char* file :
         {"tracks.csv", "health.csv", "protrusions.csv", "msd.csv", "summary.json", "fields.h5", "fields.xdmf"})
      EXPECT_EQ(text_of(folder / signal / file), text_of(folder / "whole" / file)) << signal << " " << file;
    const auto hash = [&](const std::string& name) {
      return nlohmann::json::parse(text_of(folder / name / "run.json")).at("trajectory_hash");
    };
    EXPECT_EQ(hash(signal), hash("whole")) << signal;
  }
}

TEST_F(SuddenEnd, EndsByTheSignalWhereACoreIsWanted) {
  ASSERT_EQ(::setenv("MATRIGRATE_CORE_DUMP", "1", 1), 0);
  EXPECT_EQ(told("core", "SEGV"), 128 + SIGSEGV);
  EXPECT_FALSE(contains(text_of(base / "err"), "matrigrate:"));
  ::unsetenv("MATRIGRATE_CORE_DUMP");
}

/// Takes more of the stack than there is.
int deep(int depth) {
  std::array<volatile char, 4096> taken{};
  taken[0] = static_cast<char>(depth);
  return depth == 0 ? 0 : deep(depth - 1) + taken[0];
}

TEST(SuddenEndHandler, HasAStackOfItsOwn) {
  if (someone_else_handles_them()) GTEST_SKIP() << "someone else handles these signals";
  const auto overflow = [] {
    const rlimit room{1U << 20U, 1U << 20U};
    ::setrlimit(RLIMIT_STACK, &room);
    apps::give_sudden_ends_an_exit_code();
    std::_Exit(deep(1 << 28));
  };
  EXPECT_EXIT(overflow(), testing::ExitedWithCode(4), "ended by SIGSEGV");
}

TEST(SuddenEndHandler, CatchesLibrariesThatCallExit) {
  if (someone_else_handles_them()) GTEST_SKIP() << "someone else handles these signals";
  const auto ended = [](int code) {
    apps::give_sudden_ends_an_exit_code();
    std::exit(code); // HDF5 does so with -1 where it gets no memory
  };
  EXPECT_EXIT(ended(-1), testing::ExitedWithCode(4), "ended by a library that called exit");
  for (const int code : {0, 1, 2, 3, 4, 5, 75, 130}) EXPECT_EXIT(ended(code), testing::ExitedWithCode(code), "^$");
}

TEST(SuddenEndHandler, LeavesHandlersOfOthersAlone) {
  if (someone_else_handles_them()) GTEST_SKIP() << "someone else handles these signals";
  const auto others = [] {
    std::signal(SIGSEGV, [](int) { std::_Exit(77); });
    apps::give_sudden_ends_an_exit_code();
    std::raise(SIGSEGV);
  };
  EXPECT_EXIT(others(), testing::ExitedWithCode(77), "");
}

} // namespace
} // namespace matrigrate
