#include "report/claims_page.hpp"

#include "unit/draw/markup.hpp"

#include <gtest/gtest.h>

namespace matrigrate::report {
namespace {

ClaimSection claim(const std::string& verdict, const std::string& caveat) {
  return {.id = "A2",
          .sentence = "rises & stays",
          .published = "4.1 um/h",
          .verdict = verdict,
          .caveat = caveat,
          .ours = {"at 50 Pa 4.4 [3.1, 5.7]", "at 200 Pa 9.3"},
          .conditions = {"p 0.001: met"},
          .figures = {{"figure", "What it shows.", "<svg></svg>"}}};
}

TEST(ClaimsPage, SaysBesideEachVerdictWhatTheRunsAreNot) {
  const std::string html = claims_page("Claims", {}, "Replicates: 2.",
                                       {claim("holds", "not the paper's runs"), claim("does not hold", "")}, "");
  EXPECT_EQ(
      occurrences(html, "<span class=\"holds\">holds</span> <span class=\"caveat\">not the paper&#39;s runs</span>"),
      2U)
      << "overview and chapter";
  EXPECT_EQ(occurrences(html, "class=\"caveat\""), 2U) << "not beside the other";
  const std::size_t note = html.find("<p class=\"notice\">Replicates: 2.</p>");
  ASSERT_NE(note, std::string::npos);
  EXPECT_LT(note, html.find("1 of 2 hold.")) << "before any verdict";
  EXPECT_EQ(occurrences(claims_page("Claims", {}, "As published.", {claim("holds", "")}, ""), "<p class=\"notice\""),
            0U);
}

TEST(ClaimsPage, KeepsUndecidedApartFromFalse) {
  const std::string html = claims_page("Claims", {}, "", {claim("undecided", ""), claim("holds", "")}, "");
  EXPECT_EQ(occurrences(html, "1 of 2 hold, 1 undecided."), 1U);
  EXPECT_EQ(occurrences(html, "<span class=\"undecided\">undecided</span>"), 2U);
  EXPECT_EQ(occurrences(html, "<span class=\"fails\""), 0U);
}

TEST(ClaimsPage, HoldsEverythingAndIsWellFormed) {
  std::string html = claims_page("Claims", {{"command", "matrigrate reproduce A"}, {"runs done", "6 of 6"}}, "x",
                                 {claim("holds", "")}, "commit 1234");
  EXPECT_LT(html.find("command: matrigrate reproduce A"), html.find("runs done: 6 of 6"));
  EXPECT_LT(html.find("runs done: 6 of 6"), html.find("1 of 1 hold."));
  EXPECT_EQ(occurrences(html, "4.1 um/h"), 2U) << "overview and chapter";
  for (const char* text :
       {"<li>at 50 Pa 4.4 [3.1, 5.7]</li>", "<li>at 200 Pa 9.3</li>", "p 0.001: met", "What it shows.", "commit 1234"})
    EXPECT_EQ(occurrences(html, text), 1U) << text;
  EXPECT_EQ(occurrences(html, "rises &amp; stays"), 2U);
  html = html.substr(html.find("<body>")); // the head has elements that HTML leaves open
  html.resize(html.find("</html>"));
  EXPECT_TRUE(parsed(html));
}

} // namespace
} // namespace matrigrate::report
