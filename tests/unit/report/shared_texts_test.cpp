#include "base/file.hpp"
#include "report/run_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

/// What the viewer and the documents say as the program does.
namespace matrigrate {
namespace {

/// A file of the source, with line breaks as blanks.
std::string source(const std::string& name) {
  std::string text = read_file(std::filesystem::path(MATRIGRATE_SOURCE_DIR) / name, 1U << 20U);
  std::ranges::replace(text, '\n', ' ');
  return text;
}

TEST(SharedTexts, NameThePaperByItsWholeTitle) {
  const std::string title = "The role of actin protrusion dynamics in cell migration through a degradable viscoelastic "
                            "extracellular matrix: Insights from a computational model";
  EXPECT_NE(report::citation().find(title + ". PLoS Comput Biol"), std::string::npos);
  for (const char* name : {"README.md", "CITATION.cff"}) EXPECT_NE(source(name).find(title), std::string::npos) << name;
}

TEST(SharedTexts, CitationGivesCreditToTheProgramToo) {
  const std::string citation = source("CITATION.cff");
  EXPECT_NE(citation.find("references:"), std::string::npos);
  EXPECT_EQ(citation.find("preferred-citation:"), std::string::npos) << "readers would cite nothing else";
}

} // namespace
} // namespace matrigrate
