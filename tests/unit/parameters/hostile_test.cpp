#include "base/file.hpp"
#include "faults.hpp"
#include "parameters/document.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <random>

namespace matrigrate {
namespace {

namespace fs = std::filesystem;

std::string repeated(std::string_view text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

bool printable(const std::string& text) {
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return false;
  return true;
}

TEST(Hostile, BytesThatAreNoTextAreOneClearFault) {
  const std::string nul("[ecm]\nra\0dius = 1\n[emc]\n", 23);
  EXPECT_EQ(fault_of(nul), "f.toml:2:3: is not a text file: byte 0x00 is no character of UTF-8 text");
  EXPECT_EQ(fault_of("a = \"\x07\""), "f.toml:1:6: is not a text file: byte 0x07 is no character of UTF-8 text");
  EXPECT_EQ(fault_of("# \xff"), "f.toml:1:3: is not a text file: byte 0xff is no character of UTF-8 text");
  EXPECT_EQ(fault_of("# µ\xc0\xaf"), "f.toml:1:4: is not a text file: byte 0xc0 is no character of UTF-8 text");
  EXPECT_EQ(fault_of("# \xed\xa0\x80"), "f.toml:1:3: is not a text file: byte 0xed is no character of UTF-8 text");
  EXPECT_EQ(fault_of("# \xe2\x82"), "f.toml:1:3: is not a text file: byte 0xe2 is no character of UTF-8 text");
  EXPECT_TRUE(faults_of("# \xf0\x9f\xa7\xac \xe2\x82\xac µ\n").empty()) << "real text";
}

// What a C library reads ends at a NUL, and the record would show the whole text.
TEST(Hostile, ControlCharactersInTextsAreRefused) {
  const std::string fault = fault_of("[laws]\npolarization_rate = \"r_pol\\u0000*100\"\n");
  EXPECT_EQ(fault.find("f.toml:2:21: a text holds the control character U+0000"), 0U) << fault;
  EXPECT_NE(fault_of("[laws.constants]\nF_c = \"1\\u0001 nN\"\n").find("U+0001"), std::string::npos);
  EXPECT_NE(fault_of("[[cells]]\nx = \"1 um\"\ny = \"1 um\"\nname = [\"a\\u007f\"]\n").find("U+007F"),
            std::string::npos);
  EXPECT_NE(fault_of("", {"laws.polarization_rate=\"r_pol\\u0000*100\""}).find("U+0000"), std::string::npos);
}

TEST(Hostile, RandomBytesNeverPass) {
  std::mt19937 random(7);
  for (int file = 0; file < 300; ++file) {
    std::string bytes(1 + random() % 2000, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    for (const std::string& fault : faults_of(bytes)) EXPECT_TRUE(printable(fault)) << fault;
  }
}

TEST(Hostile, RandomTextOfTomlSignsIsSurvived) {
  const std::string signs = "[]{}=.,\"'#\n\n\t abez019-+_\\\r";
  std::mt19937 random(11);
  for (int file = 0; file < 1500; ++file) {
    std::string text(random() % 300, ' ');
    for (char& c : text) c = signs[random() % signs.size()];
    for (const std::string& fault : faults_of(text)) EXPECT_TRUE(printable(fault)) << fault;
  }
}

class Nested : public testing::TestWithParam<std::string> {};

TEST_P(Nested, DoesNotExhaustTheStack) {
  const std::string fault = fault_of(GetParam());
  EXPECT_NE(fault.find("is nested deeper than 32 levels"), std::string::npos) << fault.substr(0, 300);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Nested,
                         testing::Values("x = " + repeated("[", 200000), "x = " + repeated("{a = ", 100000),
                                         repeated("a.", 300000) + "a = 1", "[" + repeated("a.", 300000) + "a]",
                                         repeated("\"a,\".", 100000) + "a = 1", "x = " + repeated("[{a.a.a = ", 50000),
                                         "x = '''\n\"''' \n" + repeated("b.", 100000) + "b = 1",
                                         "x = [\n" + repeated("[\n", 100000)));

TEST(Hostile, DotsAndBracketsInTextAreNoNesting) {
  EXPECT_TRUE(faults_of("# " + repeated("a.", 500) + "\n# " + repeated("[", 500) + "\n").empty());
  EXPECT_TRUE(faults_of(repeated("[ecm]\n", 1) + repeated("# [x]\n", 200)).empty());
}

TEST(Hostile, LongLinesAndKeysAreCutInMessages) {
  for (const std::string& text :
       {std::string(200000, 'k') + " = 1", "ecm.lattice = \"" + std::string(200000, 'v') + "\"",
        "ecm.radius = \"" + std::string(200000, '9') + " um\"", "ecm.radius = " + std::string(200000, '9'),
        "[" + std::string(200000, 's') + "]", "[ecm]\nradius = 1 " + std::string(200000, 'x')}) {
    const std::string fault = fault_of(text);
    EXPECT_LT(fault.size(), 500u) << fault.substr(0, 600);
    EXPECT_NE(fault.find("f.toml:"), std::string::npos) << fault.substr(0, 600);
  }
}

TEST(Hostile, ManyFaultsAreCut) {
  std::string text = "[ecm]\n";
  for (int i = 0; i < 5000; ++i) text += fmt::format("key_{} = 1\n", i);
  const auto faults = faults_of(text);
  ASSERT_EQ(faults.size(), 201u);
  EXPECT_EQ(faults.front().substr(0, 23), "f.toml:2:1: ecm.key_0: ");
  EXPECT_EQ(faults.back(), "f.toml: has 4800 more faults");
}

TEST(Hostile, OneSyntaxErrorIsToldAlone) {
  EXPECT_EQ(fault_of(repeated("= 1\n", 5000)).substr(0, 31), "f.toml:1:1: cannot be read as T");
  EXPECT_EQ(
      fault_of("[ecm]\nradius = 1\nviscosity = 1000 Pa s\nlattice = 3\n[emc]\n"),
      "f.toml:3:18: cannot be read as TOML: Error while parsing key-value pair: expected a comment or whitespace, "
      "saw 'P'; text, and numbers with a unit, stand in quotes");
  EXPECT_EQ(fault_of("[ecm]\nradius = 100\nradius = 120\n").substr(0, 12), "f.toml:3:10:");
  EXPECT_EQ(fault_of("[ecm]\n[run]\n[ecm]\n").substr(0, 12), "f.toml:3:1: ");
  EXPECT_EQ(fault_of("[ecm]\n[run]\n[ecm]\n").find("quotes"), std::string::npos); // no value is at fault
}

TEST(Hostile, RulesAreNotJudgedOverAFileThatIsNotRead) {
  const auto faults = faults_of("= 1\n", {"ecm.radius=20", "run.sed=1"});
  ASSERT_EQ(faults.size(), 2U) << faults.back();
  EXPECT_EQ(faults[1], "--set: run.sed: there is no such parameter; did you mean run.seed?");
}

/// Whatever stands in a megabyte, it is read in one pass. A reader that looks at a run of quotes, or for the nearest
/// name of a key, more often than that takes minutes to hours over these.
TEST(Hostile, AMegabyteIsReadInOnePass) {
  EXPECT_EQ(faults_of(repeated("\"", 1'000'000)).size(), 1U);
  EXPECT_EQ(faults_of("a = \"\"\"" + repeated("\"", 1'000'000)).size(), 1U);
  EXPECT_EQ(faults_of("a = ''' " + repeated("''  ", 250'000)).size(), 1U);
  const auto many = [](const std::string& head, std::string_view before, std::string_view after, int n) {
    std::string text = head;
    for (int i = 0; i < n; ++i) text += fmt::format("{}{}{}", before, i, after);
    return text;
  };
  EXPECT_EQ(faults_of(many("[ecm]\n", "k", " = 1\n", 60'000)).back(), "f.toml: has 59800 more faults");
  EXPECT_EQ(faults_of(many("", "[s", "]\n", 90'000)).back(), "f.toml: has 89800 more faults");
  EXPECT_EQ(faults_of(many("ecm = {z = 1", ", k", " = 1", 80'000) + "}\n").back(), "f.toml: has 79801 more faults");
  EXPECT_EQ(fault_of(many("", "a", ".b = 1\n", 60'000)),
            "f.toml:50001:10: has more than 50000 dotted keys; write sections");
}

/// A new folder for each test.
class HostileFile : public testing::Test {
protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "matrigrate-hostile-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { fs::remove_all(folder); }

  static std::string error_of_file(const fs::path& path) {
    try {
      read_parameters(path);
    } catch (const InputOutputError& error) {
      return error.what();
    }
    return "good";
  }

  fs::path folder;
};

TEST_F(HostileFile, MissingFileAndFolder) {
  EXPECT_EQ(error_of_file(folder / "none.toml"),
            (folder / "none.toml").string() + ": cannot be read: No such file or directory");
  EXPECT_EQ(error_of_file(folder), folder.string() + ": is a folder, not a file");
}

TEST_F(HostileFile, AHundredMegabytesAreRefusedBySize) {
  const fs::path path = folder / "large.toml";
  std::ofstream(path) << "[ecm]\n";
  fs::resize_file(path, 100 << 20); // sparse: takes no room on disk
  try {
    read_parameters(path);
    FAIL() << "a file of 100 MB was read";
  } catch (const ConfigurationError& error) {
    ASSERT_EQ(error.faults().size(), 1U);
    EXPECT_EQ(to_string(error.faults()[0]), path.string() + ": has 104857600 bytes, more than the 1048576 allowed");
  }
}

TEST_F(HostileFile, AGoodFileIsRead) {
  write_file(folder / "f.toml", "ecm.youngs_modulus = \"50 Pa\"\n");
  EXPECT_EQ(read_parameters(folder / "f.toml", {"run.seed=3"}).ecm.youngs_modulus, 0.05);
}

TEST(Scan, ExcerptsAreShortAndPrintable) {
  EXPECT_EQ(excerpt("abc"), "abc");
  EXPECT_EQ(excerpt("a\nb\x01\xff"), "a?b??");
  EXPECT_EQ(excerpt("µµµµ", 2), "µµ...");
}

} // namespace
} // namespace matrigrate
