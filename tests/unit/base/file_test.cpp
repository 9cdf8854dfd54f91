#include "base/failure.hpp"
#include "base/file.hpp"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <string>

namespace matrigrate {
namespace {

namespace fs = std::filesystem;

/// A new folder for each test.
class File : public testing::Test {
protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "matrigrate-file-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { fs::remove_all(folder); }

  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  fs::path folder;
};

/// The reason with which a call fails.
template <class Call>
std::string reason(const Call& call) {
  try {
    call();
  } catch (const InputOutputError& error) {
    return error.what();
  }
  return "no failure";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(File, WhatIsWrittenIsReadBack) {
  const std::string content("a\0b\r\n\xff", 6);
  write_file(folder / "f", content);
  EXPECT_EQ(read_file(folder / "f", 6), content);
  write_file(folder / "f", "");
  EXPECT_EQ(read_file(folder / "f", 0), "");
  EXPECT_EQ(entries(), 1u) << "a temporary file is left";
}

TEST_F(File, ManyBytesAreReadBack) {
  std::string content(1 << 20, 'x');
  content.back() = 'y';
  write_file(folder / "f", content);
  EXPECT_EQ(read_file(folder / "f", 1 << 20), content);
}

TEST_F(File, AFailedWriteLeavesTheOldFile) {
  const std::string in_nowhere = reason([&] { write_file(folder / "nowhere" / "f", "x"); });
  EXPECT_TRUE(contains(in_nowhere, "nowhere/f: cannot be written: No such file or directory")) << in_nowhere;
  fs::create_directory(folder / "d");
  EXPECT_TRUE(contains(reason([&] { write_file(folder / "d", "x"); }), "is a folder"));
  EXPECT_TRUE(contains(reason([] { write_file("/dev/null", "x"); }), "not a regular file"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(File, NamesOfTemporaryFilesAreKnown) {
  EXPECT_EQ(file_of_temporary(".fields.h5.a1B2c3"), "fields.h5");
  for (const char* name : {"", ".", ".lock", "fields.h5", ".fields.h5.a1B2c", ".fields.h5.a1B2c34", "fields.h5.a1B2c3",
                           ".fields.h5.a1B-c3", "..a1B2c3"})
    EXPECT_FALSE(file_of_temporary(name)) << name;
}

TEST_F(File, WrittenFilesHaveTheUsualPermissions) {
  write_file(folder / "f", "x");
  std::ofstream(folder / "g") << "x";
  EXPECT_EQ(fs::status(folder / "f").permissions(), fs::status(folder / "g").permissions());
}

TEST_F(File, RefusesToReadWhatIsNoFile) {
  EXPECT_TRUE(contains(reason([&] { read_file(folder, 10); }), "is a folder"));
  EXPECT_TRUE(contains(reason([&] { read_file(folder / "none", 10); }), "No such file"));
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_TRUE(contains(reason([&] { read_file(folder / "pipe", 10); }), "not a regular file")) << "and does not wait";
}

TEST_F(File, RefusesToReadWhatIsTooLarge) {
  std::ofstream(folder / "f") << "12345";
  EXPECT_EQ(read_file(folder / "f", 5), "12345");
  const std::string message = reason([&] { read_file(folder / "f", 4); });
  EXPECT_TRUE(contains(message, "has 5 bytes, more than the 4 allowed")) << message;
}

TEST_F(File, MakesFolders) {
  make_folder(folder / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder / "a" / "b"));
  write_file(folder / "a" / "b" / "f", "x");
  make_folder(folder / "a" / "b");
  EXPECT_EQ(read_file(folder / "a" / "b" / "f", 1), "x") << "nothing is deleted";
  EXPECT_TRUE(contains(reason([&] { make_folder(folder / "a" / "b" / "f"); }), "not a folder"));
}

TEST_F(File, Grows) {
  GrowingFile file(folder / "f", "head\n");
  EXPECT_EQ(read_file(folder / "f", 99), "head\n");
  file.append("a\n");
  file.append("b\n");
  file.flush();
  EXPECT_EQ(read_file(folder / "f", 99), "head\na\nb\n");
  EXPECT_TRUE(contains(reason([&] { GrowingFile(folder / "none" / "f", ""); }), "none/f: cannot be written"));
}

TEST_F(File, TakesBackAPieceThatDoesNotFit) {
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  GrowingFile file(folder / "f", "head\n");
  rlimit limit = old_limit;
  limit.rlim_cur = 10;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  const std::string message = reason([&] { file.append("too long\n"); });
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_TRUE(contains(message, "f: cannot be written: File too large")) << message;
  EXPECT_EQ(read_file(folder / "f", 99), "head\n");
  file.append("fits\n");
  EXPECT_EQ(read_file(folder / "f", 99), "head\nfits\n");
}

TEST_F(File, RenamesOverAnother) {
  write_file(folder / "a", "new");
  write_file(folder / "b", "old");
  rename_file(folder / "a", folder / "b");
  EXPECT_EQ(read_file(folder / "b", 10), "new");
  EXPECT_EQ(entries(), 1u);
  EXPECT_TRUE(contains(reason([&] { rename_file(folder / "none", folder / "b"); }), "No such file"));
}

} // namespace
} // namespace matrigrate
