#include "apps/export/named_pipe.hpp"

#include "base/file.hpp"
#include "base/process.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

namespace matrigrate::apps {
namespace {

std::filesystem::path fresh_folder(const std::string& name) {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("matrigrate-{}-{}", name, ::getpid());
  std::filesystem::create_directory(folder);
  return folder;
}

void wait_for(Child& child) {
  while (!child.ended()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(NamedPipe, AChildThatOpensItLateReadsAllOfIt) {
  const std::filesystem::path folder = fresh_folder("late");
  NamedPipe pipe(folder / "pipe");
  Child child({"sh", "-c", "sleep 0.3; cat \"$1\" > \"$2\"", "sh", pipe.path(), folder / "copy"}, STDERR_FILENO);
  const std::string text(1000, 'x');
  ASSERT_TRUE(pipe.write(text, child));
  ASSERT_TRUE(pipe.finish(child));
  wait_for(child);
  EXPECT_EQ(read_file(folder / "copy", 10000), text);
  std::filesystem::remove_all(folder);
}

TEST(NamedPipe, AChildThatEndsEarlyIsNoticed) {
  const std::filesystem::path folder = fresh_folder("early");
  NamedPipe pipe(folder / "pipe");
  Child child({"sh", "-c", "sleep 0.1"}, STDERR_FILENO);
  ASSERT_TRUE(pipe.write("x", child));
  EXPECT_FALSE(pipe.finish(child));
  std::filesystem::remove_all(folder);
}

} // namespace
} // namespace matrigrate::apps
