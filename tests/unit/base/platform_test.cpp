// Compiled twice: with what this system is taken for, and with platform_portable.cpp, which other systems get.
#include "base/failure.hpp"
#include "base/platform.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>

namespace matrigrate::platform {

namespace {

using namespace std::chrono_literals;

/// A process that catches SIGTERM and ends with its number; it says when it is ready.
class Catcher {
public:
  Catcher() {
    int pipe[2];
    if (::pipe(pipe) != 0) std::abort();
    m_id = ::fork();
    if (m_id == 0) {
      std::signal(SIGTERM, [](int number) { ::_exit(number); });
      if (::write(pipe[1], "r", 1) != 1) ::_exit(1);
      for (;;) ::pause();
    }
    char ready = 0;
    if (::read(pipe[0], &ready, 1) != 1) std::abort();
    ::close(pipe[0]);
    ::close(pipe[1]);
  }
  Catcher(const Catcher&) = delete;
  Catcher& operator=(const Catcher&) = delete;
  ~Catcher() {
    ::kill(m_id, SIGKILL);
    ::waitpid(m_id, nullptr, 0);
  }
  pid_t id() const { return m_id; }

private:
  pid_t m_id = -1;
};

/// An open file that is removed at the end.
class OpenFile {
public:
  OpenFile() : m_descriptor(::mkstemp(m_path)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    ::close(m_descriptor);
    ::unlink(m_path);
  }
  int descriptor() const { return m_descriptor; }
  int opened_again() const { return ::open(m_path, O_RDWR | O_CLOEXEC); }

private:
  char m_path[32] = "platform_test.XXXXXX";
  int m_descriptor;
};

} // namespace

TEST(Platform, NamesTheFileOfThisProgram) {
  const std::string called = std::filesystem::read_symlink("/proc/self/exe");
  begin(called.c_str());
  EXPECT_EQ(program_file(), called);
  EXPECT_TRUE(std::filesystem::equivalent(this_program(), called));
}

TEST(Platform, FindsTheProgramAsTheShellDid) {
  const std::filesystem::path called = std::filesystem::read_symlink("/proc/self/exe");
  ASSERT_EQ(::setenv("PATH", ("/nowhere:" + called.parent_path().string()).c_str(), 1), 0);
  begin(called.filename().c_str());
  EXPECT_EQ(program_file(), called);
}

TEST(Platform, TellsThatAProcessCatchesASignalAndPassesItOn) {
  const Catcher process;
  EXPECT_TRUE(catches(process.id(), SIGTERM, 2s));
  EXPECT_TRUE(pass_on(process.id(), SIGTERM));
  int status = 0;
  ASSERT_EQ(::waitpid(process.id(), &status, 0), process.id());
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == SIGTERM);
}

TEST(Platform, LocksExcludeEachOther) {
  const OpenFile file;
  const int other = file.opened_again();
  ASSERT_GE(other, 0);
  EXPECT_EQ(lock(file.descriptor(), Lock::shared), 0);
  EXPECT_EQ(lock(other, Lock::shared), 0);
  EXPECT_EQ(lock(other, Lock::alone), EWOULDBLOCK);
  ::close(other);
  EXPECT_EQ(lock(file.descriptor(), Lock::alone), 0);
}

/// Commands of the runs of a study keep the lock of their pool.
TEST(Platform, AProcessThatInheritsALockKeepsIt) {
  const OpenFile file;
  const int first = file.opened_again();
  ASSERT_EQ(lock(first, Lock::alone), 0);
  {
    const Catcher process;
    ::close(first);
    EXPECT_EQ(lock(file.descriptor(), Lock::shared), EWOULDBLOCK);
  }
  EXPECT_EQ(lock(file.descriptor(), Lock::shared), 0);
}

TEST(Platform, TimesOfAFileChangeWithIt) {
  const OpenFile file;
  const auto times = [&] {
    struct stat status {};
    EXPECT_EQ(::fstat(file.descriptor(), &status), 0);
    return times_of(status);
  };
  const auto before = times();
  const timespec earlier[2] = {{.tv_sec = 1000, .tv_nsec = 0}, {.tv_sec = 1000, .tv_nsec = 0}};
  ASSERT_EQ(::futimens(file.descriptor(), earlier), 0);
  EXPECT_NE(times(), before);
  EXPECT_EQ(times()[0], 1000);
}

TEST(Platform, ALockOfNoFileIsAnError) { EXPECT_EQ(lock(-1, Lock::alone), EBADF); }

TEST(Platform, WhatCannotBeToldIsEmpty) { EXPECT_EQ(processor("no processor has this"), ""); }

} // namespace matrigrate::platform
