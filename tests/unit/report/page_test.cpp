#include "report/page.hpp"

#include "unit/draw/markup.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace matrigrate::report {
namespace {

PageSection section(bool holds) {
  return {"relaxation",
          "Stress decays.",
          holds,
          {{"stress [Pa]", "1.01", "1", "0.02", "two percent", verdict(holds)}},
          {"a remark"},
          {{"figure", "What it shows.",
            "<?xml version=\"1.0\"?>\n<svg><g id=\"a\"/><use href=\"#a\" fill=\"url(#a)\"/></svg>"}}};
}

TEST(Page, NamesVerdictsInWords) {
  const std::string html = page("Report", {section(true), section(false)}, "");
  EXPECT_EQ(occurrences(html, ">holds<"), 3U) << "overview, chapter, check";
  EXPECT_EQ(occurrences(html, ">does not hold<"), 3U);
  EXPECT_EQ(occurrences(html, "1 of 2 hold."), 1U);
}

TEST(Page, HoldsEverythingOfASection) {
  const std::string html = page("Report", {section(true)}, "commit 1234\nseed 5");
  for (const char* text :
       {"stress [Pa]", "1.01", "0.02", "two percent", "a remark", "What it shows.", "commit 1234\nseed 5"})
    EXPECT_EQ(occurrences(html, text), 1U) << text;
  EXPECT_EQ(occurrences(html, "Stress decays."), 2U);
  for (const char* column : {"quantity", "measured", "expected", "tolerance", "why this tolerance", "verdict"})
    EXPECT_EQ(occurrences(html, std::string("<th scope=\"col\">") + column + "</th>"),
              std::string_view(column) == "verdict" ? 2U : 1U)
        << column;
}

TEST(Page, KeepsTheIdsOfPicturesApart) {
  PageSection twice = section(true);
  twice.figures.push_back(twice.figures[0]);
  const std::string html = page("Report", {twice, section(true)}, "");
  for (const char* id : {"s1f1-a", "s1f2-a", "s2f1-a"}) {
    EXPECT_EQ(occurrences(html, std::string(" id=\"") + id + '"'), 1U) << id;
    EXPECT_EQ(occurrences(html, std::string("href=\"#") + id + '"'), 1U) << id;
    EXPECT_EQ(occurrences(html, std::string("url(#") + id + ')'), 1U) << id;
  }
  EXPECT_EQ(occurrences(html, "<?xml"), 0U);
}

TEST(Page, NeedsNothingFromOutside) {
  const std::string html = page("Report", {section(true)}, "");
  for (const char* outside : {"<script", "<link", "src=", "@import", "http://", "https://"})
    EXPECT_EQ(occurrences(html, outside), 0U) << outside;
}

TEST(Page, EscapesAllText) {
  const std::string evil = "<script>\"&";
  PageSection s{evil, evil, false, {{evil, evil, evil, evil, evil, evil}}, {evil}, {{"f", evil, "<svg></svg>"}}};
  const std::string html = page(evil, {s}, evil);
  EXPECT_EQ(occurrences(html, "<script"), 0U);
  EXPECT_EQ(occurrences(html, "&lt;script&gt;&quot;&amp;"), 15U);
}

TEST(Page, IsWellFormed) {
  std::string html = page("Report", {section(true), section(false)}, "p");
  html = html.substr(html.find("<body>")); // the head has elements that HTML leaves open
  html.resize(html.find("</html>"));
  EXPECT_TRUE(parsed(html));
}

TEST(Page, RefusesRowsAndFiguresThatItCannotShow) {
  PageSection s = section(true);
  s.check_rows[0].pop_back();
  EXPECT_THROW(page("Report", {s}, ""), std::invalid_argument);
  s = section(true);
  s.figures[0].svg = "nothing";
  EXPECT_THROW(page("Report", {s}, ""), std::invalid_argument);
}

} // namespace
} // namespace matrigrate::report
