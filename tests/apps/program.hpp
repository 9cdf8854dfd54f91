#pragma once

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace matrigrate {

/// How a run of the program ended.
struct Ended {
  int code = -1;
  std::string out;
  std::string err;
};

/// Runs the program in a new folder for each test.
class Program : public testing::Test {
protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "matrigrate-apps-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    base = name;
    folder = base / "work";
    std::filesystem::create_directory(folder);
  }
  void TearDown() override { std::filesystem::remove_all(base); }

  /// @param arguments  as a shell takes them
  /// @param program    a copy of the program
  Ended run(const std::string& arguments, const std::string& program = MATRIGRATE_PROGRAM) const {
    const std::string command = "cd '" + folder.string() + "' && '" + program + "' " + arguments + " >'"
                                + (base / "out").string() + "' 2>'" + (base / "err").string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(base / "out"), text_of(base / "err")};
  }

  /// Starts the program, waits for one of its files, for as long as it takes, and then sends it a signal.
  /// @param arguments  as a shell takes them
  /// @param file       name in the folder of the test
  /// @param telling    the shell's command that tells process $p
  /// @return           its exit code
  int stopped(const std::string& arguments, const std::string& file, const std::string& telling) const {
    std::ofstream(base / "stop.sh") << "cd '" << folder.string() << "'; setsid '" MATRIGRATE_PROGRAM "' " << arguments
                                    << " >'" << (base / "out").string() << "' 2>'" << (base / "err").string()
                                    << "' & p=$!\n"
                                    << "while [ ! -e '" << file << "' ] && kill -0 $p; do sleep 0.01; done\n"
                                    << telling << "\nwait $p\n";
    return WEXITSTATUS(std::system(("bash '" + (base / "stop.sh").string() + "' 2>/dev/null").c_str()));
  }

  static std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  /// The data, as JSON text, of a page that the program wrote.
  std::string page_data(const std::string& file) const {
    const std::string page = text_of(folder / file);
    const std::string mark = "id=\"matrigrate-data\">";
    const std::size_t start = page.find(mark) + mark.size();
    std::string text = page.substr(start, page.find("</script>", start) - start);
    EXPECT_EQ(text.find('<'), std::string::npos);
    return text;
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder / name); }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
  }

  std::filesystem::path base;
  std::filesystem::path folder;
};

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace matrigrate
