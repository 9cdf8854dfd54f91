#include "documents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>

namespace matrigrate::structure {
namespace {

const std::filesystem::path root = MATRIGRATE_SOURCE_DIR;

std::string text_of(const std::string& path) {
  std::ifstream in(root / path);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void expect_none(const Findings& findings) {
  for (const std::string& finding : findings) ADD_FAILURE() << finding;
}

/// Pages of the lab book and the changelog stand as they were written: they may name what is no longer there. Their
/// links are checked.
bool is_of_the_past(const Document& page) { return page.path.starts_with("docs/lab/") || page.path == "CHANGELOG.md"; }

TEST(Documents, LinksLeadSomewhere) {
  const Tree files = tree(root);
  const auto pages = documents(root, files);
  ASSERT_GT(pages.size(), 8U);
  for (const Document& page : pages) expect_none(dead_links(page, pages, files));
}

TEST(Documents, NameFilesThatExist) {
  const Tree files = tree(root);
  for (const Document& page : documents(root, files))
    if (!is_of_the_past(page)) expect_none(missing_files(page, files));
}

TEST(Documents, CommentsNameFilesThatExist) {
  const Tree files = tree(root);
  for (const char* folder : {"src", "apps", "benchmarks", "examples", "tests"})
    for (Source source : sources(root / folder)) {
      source.path = std::string(folder) + '/' + source.path;
      if (source.path != "tests/structure/documents_test.cpp") expect_none(missing_files_in_comments(source, files));
    }
}

TEST(Documents, HeadersNameTheirTestByItsPath) {
  const std::regex test(R"(Test:\s*(?://+\s*)?(\S*))");
  for (const char* folder : {"src", "apps"})
    for (const Source& source : sources(root / folder))
      for (auto i = std::sregex_iterator(source.text.begin(), source.text.end(), test); i != std::sregex_iterator();
           ++i)
        EXPECT_TRUE((*i)[1].str().starts_with("tests/")) << folder << '/' << source.path << ": " << i->str();
}

TEST(Documents, LibrariesPageListsThePackagesThatAreInstalled) {
  const std::string setup = text_of("tools/setup.sh");
  std::set<std::string> installed = packages(setup, "packages_to_build");
  installed.merge(packages(setup, "packages_to_test"));
  installed.merge(packages(setup, "packages_for_site"));
  ASSERT_GT(installed.size(), 15U);
  EXPECT_EQ(listed(text_of("docs/libraries.md"), "## From Debian"), installed);
}

TEST(Documents, LibrariesPageListsWhatNpmInstalls) {
  const std::string package = text_of("viewer/package.json");
  const std::string wanted = package.substr(package.find("\"devDependencies\""));
  const std::regex name(R"re(\n    "([^"]+)":)re");
  std::set<std::string> installed;
  for (auto i = std::sregex_iterator(wanted.begin(), wanted.end(), name); i != std::sregex_iterator(); ++i)
    installed.insert((*i)[1]);
  ASSERT_GT(installed.size(), 4U);
  EXPECT_EQ(listed(text_of("docs/libraries.md"), "## From npm"), installed);
}

TEST(Documents, GiveCommandsThatExist) {
  std::set<std::string> known;
  for (const Source& source : sources(root / "apps")) known.merge(declared_commands(source.text));
  ASSERT_TRUE(known.contains("study") && known.contains("--output"));
  for (const Document& page : documents(root, tree(root)))
    if (!is_of_the_past(page)) expect_none(unknown_commands(page, known));
}

TEST(Documents, ExamplesAreShortAndListed) {
  const std::string page = text_of("examples/README.md");
  for (const Source& source : sources(root / "examples")) {
    EXPECT_LE(std::ranges::count(source.text, '\n'), 80) << source.path;
    EXPECT_NE(page.find('`' + source.path + '`'), std::string::npos) << source.path;
    for (const char* part : {"/// What ", "/// Equation ", "/// Check ", "/// Libraries "})
      EXPECT_NE(source.text.find(part), std::string::npos) << source.path << ": " << part;
  }
}

TEST(Documents, NoticesAreOfTheVersionThatReportsCarry) {
  const std::string package = text_of("viewer/package.json");
  std::smatch version;
  ASSERT_TRUE(std::regex_search(package, version, std::regex(R"re("plotly[^"]*": "([\d.]+)")re")));
  EXPECT_NE(text_of("NOTICES").find("version " + version[1].str() + ","), std::string::npos);
}

// The rules themselves, on text that breaks them and text that does not.

TEST(DocumentRules, AnchorsAreThoseOfGitHub) {
  EXPECT_EQ(anchors("# The paper's claims\ntext\n```\n# no heading\n```\n## A, b: `c_d` (e)\n"),
            (std::set<std::string>{"the-papers-claims", "a-b-c_d-e"}));
}

TEST(DocumentRules, FindsDeadLinks) {
  const std::vector<Document> all{{"README.md", "# Top\n[a](docs/x.md) [b](docs/x.md#part-one) [c](#top)\n"
                                                "[d](https://a.example/no.md) [e](no.md) [f](docs/x.md#no) [g](#no)\n"},
                                  {"docs/x.md", "# X\n## Part one\n[up](../README.md) ![no](p.svg)"}};
  const Tree files{"README.md", "docs/", "docs/x.md"};
  EXPECT_EQ(dead_links(all[0], all, files),
            (Findings{"README.md:3: no such file: no.md", "README.md:3: no such heading: docs/x.md#no",
                      "README.md:3: no such heading: #no"}));
  EXPECT_EQ(dead_links(all[1], all, files), (Findings{"docs/x.md:3: no such file: p.svg"}));
}

TEST(DocumentRules, FindsMissingFiles) {
  const Tree files{"src/",    "src/io/",     "src/io/plot.hpp", "tests/", "tests/unit/", "tests/unit/plot_test.cpp",
                   "viewer/", "viewer/src/", "viewer/src/run/", "docs/",  "docs/a-b.csv"};
  for (const char* good : {"`io/plot.hpp`", "plot.hpp", "src/io/", "tests/unit, tests/unit/plot_test.cpp.",
                           "`docs/a-*.csv`", "N/m^2", "and/or", "https://a.example/src/no.hpp", "`submit.sh`",
                           "runs/<hash>/", "/docs/no", "src/*/plot.hpp", "run.json"})
    EXPECT_TRUE(missing_files({"README.md", good}, files).empty()) << good;
  for (const char* bad : {"`io/no.hpp`", "no_test.cpp", "see docs/exit-codes in", "tests/no/", "`tests/unit/no_*.cpp`"})
    EXPECT_EQ(missing_files({"README.md", bad}, files).size(), 1U) << bad;
  EXPECT_TRUE(missing_files({"viewer/README.md", "`src/run/` ../docs/a-b.csv"}, files).empty());
  EXPECT_EQ(missing_files({"docs/x.md", "../docs/no.md"}, files).size(), 1U);
  EXPECT_EQ(missing_files_in_comments({"src/io/plot.hpp", "/// Test: tests/no.cpp, a_test.cpp\nint a; ///< see b.hpp\n"
                                                          "#include \"c.hpp\"\nf(\"tests/no\");\n"},
                                      files),
            (Findings{"src/io/plot.hpp:1: no such file: tests/no.cpp", "src/io/plot.hpp:1: no such file: a_test.cpp",
                      "src/io/plot.hpp:2: no such file: b.hpp"}));
}

TEST(DocumentRules, FindsUnknownCommands) {
  const std::set<std::string> known =
      declared_commands("app.add_subcommand(\"run\", \"\");\nverb->add_option(\n  \"-o,--output\", x);\n");
  EXPECT_EQ(known, (std::set<std::string>{"run", "-o", "--output"}));
  EXPECT_TRUE(
      unknown_commands({"a.md", "Matrigrate is. `matrigrate run x --output y -- --no` --no # matrigrate"}, known)
          .empty());
  EXPECT_EQ(unknown_commands({"a.md", "\nmatrigrate fly --output x --out y   # --no\n"}, known),
            (Findings{"a.md:2: no such verb or option: fly", "a.md:2: no such verb or option: --out"}));
}

TEST(DocumentRules, ReadsLists) {
  EXPECT_EQ(listed("# A\n| `x` | y |\n# B\n| name | why |\n|---|---|\n| `a`, `b` | `c` |\ntext `d`\n", "# B"),
            (std::set<std::string>{"a", "b"}));
  EXPECT_EQ(packages("x=\"\na: 1\n\"\nlist=\"\nlib-a: why\nb++: why: not\n\"\nc: 2\n", "list"),
            (std::set<std::string>{"lib-a", "b++"}));
}

} // namespace
} // namespace matrigrate::structure
