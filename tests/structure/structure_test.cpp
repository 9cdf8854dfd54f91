#include "source_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace matrigrate::structure {
namespace {

const std::filesystem::path src = std::filesystem::path(MATRIGRATE_SOURCE_DIR) / "src";

/// Runs a rule on every file of src/ and lists all that break it.
template <class Rule>
void expect_none(const Rule& rule) {
  const auto files = sources(src);
  ASSERT_GT(files.size(), 10U) << "no sources below " << src;
  for (const Source& file : files)
    for (const std::string& finding : rule(file)) ADD_FAILURE() << "src/" << finding;
}

TEST(Structure, FoldersFormNoCycle) {
  for (const auto& [folder, reached] : closure(declared_edges(src)))
    EXPECT_FALSE(reached.contains(folder)) << folder << " depends on itself";
}

TEST(Structure, FoldersNameOnlyFoldersThatExist) {
  const Graph edges = declared_edges(src);
  for (const auto& [folder, named] : edges)
    for (const std::string& other : named)
      if (other != "options" && other != "build_info") {
        EXPECT_TRUE(edges.contains(other)) << folder << " names " << other;
      }
}

TEST(Structure, WingsAreFewAndDependOneWay) {
  const std::vector<std::string> order = wings(src);
  std::set<std::string> there;
  for (const auto& entry : std::filesystem::directory_iterator(src))
    if (entry.is_directory()) there.insert(entry.path().filename());
  EXPECT_EQ(std::set<std::string>(order.begin(), order.end()), there);
  EXPECT_LE(order.size(), 9U) << "doors of src/"; // tracks is the ninth: reading, units and read-outs of measured cells
  const auto known = libraries(src);
  const auto place = [&](const std::string& library) {
    const std::string wing = std::filesystem::relative(known.at(library), src).begin()->string();
    return std::ranges::find(order, wing) - order.begin();
  };
  for (const auto& [library, named] : declared_edges(src))
    for (const std::string& other : named)
      if (known.contains(other)) {
        EXPECT_LE(place(other), place(library)) << library << " depends on " << other << ", which is in a later wing";
      }
}

TEST(Structure, RoomsAreFew) {
  const std::filesystem::path root = src.parent_path();
  std::set<std::string> top; // folders with C++; of src/ its wings
  for (const auto& entry : std::filesystem::directory_iterator(root)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory() || name.starts_with(".") || name.starts_with("build")) continue;
    for (const auto& file : std::filesystem::recursive_directory_iterator(entry))
      if (file.path().extension() == ".cpp")
        top.insert(name == "src" ? file.path().lexically_relative(src).begin()->string() : name);
  }
  EXPECT_LE(top.size(), 15U);
  std::map<std::string, int> rooms; // libraries of each wing
  for (const auto& [library, folder] : libraries(src)) ++rooms[folder.lexically_relative(src).begin()->string()];
  for (const auto& [wing, count] : rooms) EXPECT_LE(count, wing == "model" ? 9 : 8) << "libraries in src/" << wing;
  for (const auto& entry : std::filesystem::directory_iterator(src)) {
    if (!entry.is_directory() || std::filesystem::exists(entry.path() / "CMakeLists.txt")) continue;
    ADD_FAILURE() << entry.path() << " is no wing";
  }
}

TEST(Structure, IncludesFollowTheDeclaredEdges) {
  const Graph allowed = closure(declared_edges(src));
  expect_none([&](const Source& file) { return forbidden_includes(file, allowed); });
}

TEST(Structure, NoLibraryEndsTheProgram) {
  expect_none([](const Source& file) { // that one ends only the process that it has forked
    return file.path == "base/process.cpp" ? Findings{} : process_exits(file);
  });
}

TEST(Structure, ThePreprocessorOnlyIncludes) { expect_none(preprocessor_use); }

TEST(Structure, NothingGlobalCanChange) {
  expect_none([](const Source& source) {
    Findings all = mutable_globals(source);
    // the threads of oneTBB belong to the process, and so does the count by which they see work on offer
    std::erase_if(all, [](const std::string& finding) { return finding.find(" offers{0}") != std::string::npos; });
    return all;
  });
}

TEST(Structure, HeadersAreGuarded) {
  expect_none([](const Source& file) {
    const bool header = file.path.ends_with(".hpp");
    return header && !file.text.starts_with("#pragma once\n") ? Findings{file.path + ":1: starts without #pragma once"}
                                                              : Findings{};
  });
}

// Sources, too: the release compiles them in batches, with precompiled headers, and would not miss an include.
TEST(Structure, FilesIncludeWhatTheyName) {
  std::vector<Source> all = sources(src);
  for (Source& file : sources(src.parent_path() / "apps")) {
    file.path = "apps/" + file.path; // as it is included
    all.push_back(std::move(file));
  }
  const Graph reached = reached_includes(all);
  for (const Source& file : all)
    for (const std::string& finding : undeclared_names(file, reached)) ADD_FAILURE() << finding;
}

// The live page is built seldom; its libraries are headers alone (web/CMakeLists.txt).
TEST(Structure, SourcesOfTheLivePageNeedOnlyItsLibraries) {
  std::ifstream in(src.parent_path() / "web/CMakeLists.txt");
  const std::string cmake(std::istreambuf_iterator<char>(in), {});
  std::smatch found;
  ASSERT_TRUE(std::regex_search(cmake, found, std::regex(R"(foreach\(folder ([^)]*)\))")));
  std::istringstream folders(found[1].str());
  std::vector<std::regex> left_out;
  const std::regex filter(R"rx(list\(FILTER sources EXCLUDE REGEX "([^"]*)")rx");
  for (std::sregex_iterator it(cmake.begin(), cmake.end(), filter), end; it != end; ++it)
    left_out.emplace_back(std::regex_replace((*it)[1].str(), std::regex(R"(\\\\)"), "\\"));
  ASSERT_EQ(left_out.size(), 2U);
  const std::regex needs_library("<(tiffio|png|hdf5|H5public|zlib)\\.h>|<(tbb|oneapi|boost|CLI)/.*>|<sys/wait.h>");
  const Graph reached = reached_includes(sources(src));
  std::size_t compiled = 0;
  for (std::string folder; folders >> folder;)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(src / folder)) {
      const std::string path = "/" + std::filesystem::relative(entry.path(), src).generic_string();
      const auto is_left_out = [&](const std::regex& names) { return std::regex_search(path, names); };
      if (!path.ends_with(".cpp") || std::ranges::any_of(left_out, is_left_out)) continue;
      const auto file = std::ranges::find_if(reached, [&](const auto& of) { return path.ends_with("/" + of.first); });
      ASSERT_NE(file, reached.end()) << path;
      ++compiled;
      for (const std::string& header : file->second)
        EXPECT_FALSE(std::regex_match(header, needs_library)) << "src" << path << " includes " << header;
    }
  EXPECT_GT(compiled, 80U);
}

// Without it CMake takes a script for one of its first versions, and warns at each build.
TEST(Structure, ScriptsOfCMakeNameItsVersion) {
  const std::filesystem::path root = src.parent_path();
  const auto text = [](const std::filesystem::path& file) {
    std::ifstream in(file);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string main = text(root / "CMakeLists.txt");
  int scripts = 0;
  for (const char* folder : {"cmake", "tests"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      const std::string name = entry.path().filename().string();
      if (!name.ends_with(".cmake") || main.find("include(cmake/" + name + ")") != std::string::npos) continue;
      ++scripts;
      EXPECT_NE(text(entry.path()).find("cmake_minimum_required("), std::string::npos) << entry.path();
    }
  EXPECT_GE(scripts, 5);
}

TEST(Structure, FilesStayReadable) { // how many there are: budget.py
  const std::filesystem::path root = MATRIGRATE_SOURCE_DIR;
  constexpr std::ptrdiff_t max_lines = 600; // functions: below
  for (const char* top : {"src", "apps", "python/core", "examples"})
    for (const Source& file : sources(root / top))
      EXPECT_LE(std::count(file.text.begin(), file.text.end(), '\n'), max_lines) << top << '/' << file.path;
}

TEST(Structure, FunctionsStayReadable) {
  const std::filesystem::path root = MATRIGRATE_SOURCE_DIR;
  // Tables that are written as a function, and two long specimens.
  const std::set<std::string> left_out{"parameters/presets.cpp", "observe/readout_table.cpp",
                                       "validation/poiseuille.cpp", "validation/load.cpp"};
  for (const char* top : {"src", "apps", "python/core"})
    for (const Source& file : sources(root / top))
      if (!left_out.contains(file.path))
        for (const std::string& finding : long_functions(file, 60)) ADD_FAILURE() << top << '/' << finding;
}

// The rules themselves, on text that breaks them and text that does not.

TEST(StructureRules, CodeOnlyBlanksCommentsAndLiterals) {
  EXPECT_EQ(code_only("a // b\nc"), "a     \nc");
  EXPECT_EQ(code_only("a /* b\n */ c"), "a     \n    c");
  EXPECT_EQ(code_only(R"(f("x \" // y") + 'z')"), R"(f("         ") + ' ')");
  EXPECT_EQ(code_only("n = 10'000; // x"), "n = 10'000;     ");
  EXPECT_EQ(code_only("R\"a(int x;\n)\" )a\" y"), "R         \n     \" y");
  EXPECT_EQ(code_only("\"a//b\" // c", true), "\"a//b\"     ");
}

TEST(StructureRules, FindsLongFunctions) {
  const std::string body = "  a();\n  b();\n";
  const std::string text = "#pragma once\nnamespace x {\n\n/// A.\ntemplate <class T>\nvoid f(int a,\n       int b) {\n"
                           + body + "}\n\nstruct S {\n" + body + body + "};\n} // namespace x\n";
  EXPECT_TRUE(long_functions({"x/a.cpp", text}, 5).empty());
  EXPECT_EQ(long_functions({"x/a.cpp", text}, 4), Findings{"x/a.cpp:6: a function of 5 lines"});
}

TEST(StructureRules, DeclaredFoldersAreReadWithThoseThatTheyName) {
  const Graph declared =
      declared_folders("# matrigrate_folder(no)\nmatrigrate_folder(store DEPENDS matrigrate_observe\n"
                       "  fmt::fmt matrigrate_state)\nmatrigrate_folder(draw LIGHT DEPENDS matrigrate_store)\n");
  EXPECT_EQ(declared, (Graph{{"store", {"observe", "state"}}, {"draw", {"store"}}}));
  EXPECT_TRUE(declared_folders("add_library(x)").empty());
}

TEST(StructureRules, ClosureFollowsEdgesAndShowsCycles) {
  const Graph reach = closure({{"a", {"b"}}, {"b", {"c"}}, {"c", {}}, {"d", {"e"}}, {"e", {"d"}}});
  EXPECT_EQ(reach.at("a"), (std::set<std::string>{"b", "c"}));
  EXPECT_FALSE(reach.at("a").contains("a"));
  EXPECT_TRUE(reach.at("d").contains("d"));
}

TEST(StructureRules, FindsForbiddenIncludes) {
  const Graph allowed{{"sph", {"base"}}};
  const Source file{"sph/kernel.cpp",
                    "#include \"sph/kernel.hpp\"\n#include \"base/vector.hpp\"\n#include <cmath>\n"
                    "#include \"draw/svg.hpp\"\n// #include \"store/hdf5.hpp\"\n#include \"kernel.hpp\"\n"};
  const Findings findings = forbidden_includes(file, allowed);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0], "sph/kernel.cpp:4: sph may not include draw");
  EXPECT_EQ(findings[1].find("sph/kernel.cpp:6: "), 0U);
}

TEST(StructureRules, FindsNamesWithoutTheirHeader) {
  const Source vector{"base/a.hpp", "#include <vector>\n"};
  const Source good{"base/b.hpp", "#include \"base/a.hpp\"\nstd::vector<double> x();\n// std::string\n"};
  const Source bad{"base/c.hpp", "#include \"base/a.hpp\"\n// #include <cstddef>\nstd::size_t n(std::vector<int>);\n"};
  const Source source{"base/d.cpp", "#include \"base/a.hpp\"\nstd::vector<int> x;\nint y = std::min(1, 2);\n"};
  const Graph reached = reached_includes({vector, good, bad, source});
  EXPECT_EQ(reached.size(), 4U);
  EXPECT_TRUE(undeclared_names(good, reached).empty());
  EXPECT_EQ(undeclared_names(bad, reached), Findings{"base/c.hpp:3: needs #include <cstddef>"});
  EXPECT_EQ(undeclared_names(source, reached), Findings{"base/d.cpp:3: needs #include <algorithm>"});
}

TEST(StructureRules, FindsExits) {
  for (const char* bad : {"  std::exit(1);", "abort();", "  ::_exit (2);", "if (x) std::terminate();"})
    EXPECT_EQ(process_exits({"a/b.cpp", bad}).size(), 1U) << bad;
  for (const char* good : {"// exit(1)", "on_exit(f);", "timer.abort();", "\"exit(1)\"", "int exit_code(int);"})
    EXPECT_TRUE(process_exits({"a/b.cpp", good}).empty()) << good;
}

TEST(StructureRules, FindsThePreprocessor) {
  for (const char* bad : {"#ifdef X", "# if 1", "#define A 1", "#ifndef A_HPP", "#else"})
    EXPECT_EQ(preprocessor_use({"a/b.hpp", bad}).size(), 1U) << bad;
  for (const char* good : {"#pragma once", "#include <x>", "// #ifdef", "int x; // #if"})
    EXPECT_TRUE(preprocessor_use({"a/b.hpp", good}).empty()) << good;
}

TEST(StructureRules, FindsMutableGlobals) {
  for (const char* bad : {"int counter = 0;", "std::vector<int> cache;", "static double last{0.0};",
                          "inline std::atomic<int> n{0};", "thread_local Workspace w;", "  static int calls = 0;",
                          "extern int verbosity;", "std::map<int, double> table = {", "const char* name = \"x\";",
                          "int Counter::calls = 0;", "double buffer[10];", "constinit int x = 1;"})
    EXPECT_EQ(mutable_globals({"a/b.cpp", bad}).size(), 1U) << bad;
  for (const char* good :
       {"constexpr int n = 3;", "const std::string name = \"x\";", "inline constexpr double pi = 3.0;",
        "namespace io {", "struct Table {", "using Graph = std::map<int, int>;", "enum class Mark { a, b };",
        "int f(int a = 0) {", "  int local = 0;", "static const std::regex r(\"=\");", "  static const int n = 2;",
        "  static Table empty();", "double cross(const Vec2& a);", "} // namespace", "class Failure : public Error {",
        "template <class T>", "const char* const name = \"x\";", "bool operator==(const A&) const = default;",
        "constexpr std::array<int, 2> a{1, 2};"})
    EXPECT_TRUE(mutable_globals({"a/b.cpp", good}).empty()) << good;
}

} // namespace
} // namespace matrigrate::structure
