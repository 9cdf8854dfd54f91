#include "apps/terminal/progress.hpp"

#include "program.hpp"

#include <pty.h>
#include <signal.h>

#include <algorithm>
#include <cstdint>
#include <regex>
#include <vector>

namespace matrigrate {
namespace {

using apps::progress_line;
using apps::ProgressText;

TEST(ProgressLine, LeavesOutWhatThereIsNoRoomFor) {
  const ProgressText text{
      .share = 0.15, .where = "9 min 14 s of 1 h", .left = "27 s left", .remark = "2 protrusions alive of 3"};
  EXPECT_EQ(progress_line(text, 100),
            "[####--------------------] 15 %  9 min 14 s of 1 h  27 s left  2 protrusions alive of 3");
  EXPECT_EQ(progress_line(text, 79), "[##--------] 15 %  9 min 14 s of 1 h  27 s left  2 protrusions alive of 3");
  EXPECT_EQ(progress_line(text, 64), "[####--------------------] 15 %  9 min 14 s of 1 h  27 s left");
  EXPECT_EQ(progress_line(text, 39), "15 %  9 min 14 s of 1 h  27 s left");
  EXPECT_EQ(progress_line(text, 20), "15 %  27 s left");
  for (std::size_t width = 0; width < 120; ++width) EXPECT_LE(progress_line(text, width).size(), width);
}

TEST(ProgressLine, LeavesOutAnUnknownTimeLeft) {
  EXPECT_EQ(progress_line({.share = 0.5, .where = "3 of 6 runs", .left = {}, .remark = {}}, 30),
            "[#####-----] 50 %  3 of 6 runs");
}

TEST(TimeLeft, CountsOnlyWhatWasDoneInThatTime) {
  EXPECT_EQ(apps::time_left(10.0, 5.0, 20.0), "40 s left");
  EXPECT_EQ(apps::time_left(10.0, 0.0, 20.0), "") << "nothing done yet";
}

/// The program on a terminal.
class OnTerminal : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[protrusion]\ninitiation_rate = \"1e-12 1/s\"\n");
  }

  /// The first lines of a run's progress; the run is then stopped.
  std::vector<std::string> lines(const std::vector<std::string>& arguments, unsigned short columns,
                                 std::size_t wanted) const {
    winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    int terminal = -1;
    const pid_t process = ::forkpty(&terminal, nullptr, nullptr, &size);
    if (process == 0) become(arguments);
    std::string text;
    std::vector<std::string> found;
    for (char piece[4096]; found.size() < wanted;) {
      const ssize_t got = ::read(terminal, piece, sizeof(piece));
      if (got <= 0) break; // it has ended
      text.append(piece, static_cast<std::size_t>(got));
      found = drawn(text);
    }
    ::kill(process, SIGTERM);
    for (char piece[4096]; ::read(terminal, piece, sizeof(piece)) > 0;) {
    } // until it has ended
    ::waitpid(process, nullptr, 0);
    ::close(terminal);
    return found;
  }

private:
  [[noreturn]] void become(const std::vector<std::string>& arguments) const {
    ::setenv("TERM", "xterm", 1);
    std::filesystem::current_path(folder);
    std::vector<char*> words{const_cast<char*>(MATRIGRATE_PROGRAM)};
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    ::execv(MATRIGRATE_PROGRAM, words.data());
    ::_exit(127);
  }

  /// What was drawn over and over on the same line, but for the last, which may not be complete.
  static std::vector<std::string> drawn(const std::string& text) {
    const std::string clear = "\r\x1b[K";
    std::vector<std::string> all;
    for (std::size_t at = text.find(clear); at != std::string::npos;) {
      const std::size_t next = text.find(clear, at + clear.size());
      if (next != std::string::npos) all.push_back(text.substr(at + clear.size(), next - at - clear.size()));
      at = next;
    }
    return all;
  }
};

TEST_F(OnTerminal, ProgressFitsItsWidth) {
  for (const unsigned short columns : {std::uint16_t{40}, std::uint16_t{80}, std::uint16_t{120}}) {
    const std::string name = "w" + std::to_string(columns);
    const auto shown = lines({"run", "s.toml", "--hours", "1000", "-o", name}, columns, 3);
    ASSERT_EQ(shown.size(), 3U) << columns;
    for (const std::string& line : shown) {
      EXPECT_LT(line.size(), columns) << line;
      EXPECT_TRUE(contains(line, " % ")) << line;
      EXPECT_TRUE(contains(line, " left")) << line;
    }
  }
}

TEST_F(OnTerminal, TheTimeLeftIsThatOfTheResumedPart) {
  ASSERT_EQ(run("run s.toml --hours 0.05 -o here --quiet").code, 0);
  const auto shown = lines({"resume", "here", "--hours", "1000", "-o", "longer"}, 120, 1);
  ASSERT_EQ(shown.size(), 1U);
  std::smatch parts;
  ASSERT_TRUE(
      std::regex_search(shown[0], parts, std::regex(R"((\d+) min(?: (\d+) s)? of 1000 h  ([0-9.]+) (s|min|h) left)")))
      << shown[0];
  const double t = 60.0 * std::stod(parts[1]) + (parts[2].matched ? std::stod(parts[2]) : 0.0);
  // The first line comes after 0.2 s at the earliest, in which the run got from 180 s to less than t + 1 s.
  const double at_least = 0.2 * (1000.0 * 3600.0 - t) / (t + 1.0 - 180.0);
  const double unit = parts[4] == "h" ? 3600.0 : parts[4] == "min" ? 60.0 : 1.0;
  EXPECT_GT(unit * std::stod(parts[3]), 0.9 * at_least) << shown[0];
}

} // namespace
} // namespace matrigrate
