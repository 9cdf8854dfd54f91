#include "io/frame_log.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "frames.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

namespace matrigrate::io {
namespace {

TEST(FrameLog, GivesTheSameBitsBack) {
  const Film film = SmallRun().film();
  EXPECT_EQ(difference(read_log(log_bytes(film)), film), "");
}

TEST(FrameLog, GrowsByWholeFrames) {
  const Film film = SmallRun().film();
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("matrigrate-log-" + std::to_string(::getpid()));
  {
    FrameLog log(file, log_bytes({.head = film.head, .frames = {}}));
    for (const Frame& frame : film.frames) log.add(frame);
    log.flush();
  }
  EXPECT_EQ(read_file(file, 1U << 30U), log_bytes(film));
  std::filesystem::remove(file);
}

TEST(FrameLog, EndsWhereItIsCutShort) {
  const Film film = SmallRun().film();
  const std::string bytes = log_bytes(film);
  const std::string first = log_bytes({.head = film.head, .frames = {film.frames[0]}});
  const std::string none = log_bytes({.head = film.head, .frames = {}});
  EXPECT_EQ(whole_log(bytes, 9), bytes);
  EXPECT_EQ(whole_log(bytes, 1), first);
  EXPECT_EQ(whole_log(bytes, 0), none);
  for (std::size_t size = 0; size < bytes.size(); size += 97) {
    const std::string expected = size < none.size() ? "" : size < first.size() ? none : first;
    EXPECT_EQ(whole_log(std::string_view(bytes).substr(0, size), 9), expected) << size;
  }
  EXPECT_EQ(read_log(std::string_view(bytes).substr(0, bytes.size() - 1)).frames.size(), 1U);
}

TEST(FrameLog, EndsWhereItHasBeenChanged) {
  const Film film = SmallRun().film();
  const std::string first = log_bytes({.head = film.head, .frames = {film.frames[0]}});
  for (std::size_t at = first.size(); at < first.size() + 4000; at += 211) {
    std::string bytes = log_bytes(film);
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    EXPECT_LE(read_log(whole_log(bytes, 9)).frames.size(), 2U);
    if (at >= first.size() + 24) { // past lengths and fingerprint
      EXPECT_EQ(whole_log(bytes, 9), first) << at;
    }
  }
  EXPECT_EQ(whole_log("matrigrate frames 2\n", 1), "");
  EXPECT_THROW(read_log("nonsense"), InputOutputError);
  EXPECT_THROW(read_log(log_bytes(film).substr(0, 60)), InputOutputError);
}

} // namespace
} // namespace matrigrate::io
