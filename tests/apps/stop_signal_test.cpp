#include "apps/terminal/stop_signal.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <optional>

namespace matrigrate::apps {
namespace {

void wait_for_more_than_a_second() { ::usleep(1'100'000); }

TEST(StopSignal, NotesTheFirstOnly) {
  const StopSignal stop;
  EXPECT_EQ(StopSignal::received(), 0);
  std::raise(SIGTERM);
  EXPECT_EQ(StopSignal::received(), SIGTERM);
  std::raise(SIGTERM); // `timeout` tells a process, and then its group
  std::raise(SIGINT);
  EXPECT_EQ(StopSignal::received(), SIGTERM);
}

TEST(StopSignal, ASecondOneEndsTheProgramIfItComesLater) {
  const auto impatient = [](int first, int second) {
    const StopSignal stop;
    std::raise(first);
    wait_for_more_than_a_second();
    std::raise(second);
  };
  EXPECT_EXIT(impatient(SIGINT, SIGINT), testing::KilledBySignal(SIGINT), "");
  EXPECT_EXIT(impatient(SIGINT, SIGTERM), testing::KilledBySignal(SIGTERM), "");
}

TEST(StopSignal, OneBeforeTheFirstStepEndsAProgramThatDoesNotAsk) {
  const auto builds_for_ever = [](int signal, std::optional<double> limit) {
    const StopSignal stop;
    StopSignal::before_first_step(limit);
    if (signal != 0) std::raise(signal);
    for (;;) ::usleep(100'000);
  };
  EXPECT_EXIT(builds_for_ever(SIGTERM, {}), testing::ExitedWithCode(75), "stopped before the first step");
  EXPECT_EXIT(builds_for_ever(SIGINT, {}), testing::ExitedWithCode(130), "nothing is lost");
  EXPECT_EXIT(builds_for_ever(0, 0.01), testing::ExitedWithCode(75), "stopped before the first step");
}

TEST(StopSignal, OneAtTheFirstStepIsOnlyNoted) {
  const StopSignal stop;
  StopSignal::before_first_step(0.01);
  std::raise(SIGTERM);
  StopSignal::first_step();
  EXPECT_EQ(::alarm(0), 0U) << "no time is running";
  EXPECT_EQ(StopSignal::received(), SIGTERM);
}

TEST(StopSignal, WhatIsPassedOnIsNoSecondOne) {
  const StopSignal stop;
  std::raise(SIGTERM);
  wait_for_more_than_a_second();
  ASSERT_EQ(::sigqueue(::getpid(), SIGTERM, {}), 0);
  EXPECT_EQ(StopSignal::received(), SIGTERM);
}

TEST(StopSignal, WhatWasIgnoredAtAHangUpStaysSo) {
  std::signal(SIGHUP, SIG_IGN); // as `nohup` does
  {
    const StopSignal stop;
    std::raise(SIGHUP);
    EXPECT_EQ(StopSignal::received(), 0);
  }
  EXPECT_EQ(std::signal(SIGHUP, SIG_DFL), SIG_IGN);
}

TEST(StopSignal, BeginsAnewAndGivesBackWhatWas) {
  {
    const StopSignal stop;
    std::raise(SIGUSR1);
    EXPECT_EQ(StopSignal::received(), SIGUSR1);
  }
  EXPECT_EQ(std::signal(SIGUSR1, SIG_DFL), SIG_DFL);
  const StopSignal stop;
  EXPECT_EQ(StopSignal::received(), 0);
}

} // namespace
} // namespace matrigrate::apps
