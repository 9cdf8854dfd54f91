#include "draw/svg.hpp"

#include "unit/draw/markup.hpp"

#include <gtest/gtest.h>

namespace matrigrate::draw {
namespace {

TEST(Svg, EscapesMarkupAndForbiddenCharacters) {
  EXPECT_EQ(svg::escape("a < b & \"c\" > 'd'"), "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(svg::escape(std::string("x\x01y\x7fz\0w", 7)), "x y z w");
  EXPECT_EQ(svg::escape("caf\u00e9\n"), "caf\u00e9\n");
}

TEST(Svg, RoundsCoordinatesToATenthOfAPixel) {
  EXPECT_EQ(svg::coordinate(12.0), "12");
  EXPECT_EQ(svg::coordinate(12.04), "12");
  EXPECT_EQ(svg::coordinate(12.06), "12.1");
  EXPECT_EQ(svg::coordinate(-0.04), "0");
  EXPECT_EQ(svg::coordinate(-3.25e1), "-32.5");
}

TEST(Svg, WrapsTextAtSpaces) {
  EXPECT_TRUE(svg::wrapped("", 100.0, 10.0).empty());
  EXPECT_EQ(svg::wrapped("one  two ", 1000.0, 10.0), (std::vector<std::string>{"one two"}));
  EXPECT_EQ(svg::wrapped("one two three", svg::text_width("one two", 10.0), 10.0),
            (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(svg::wrapped("incompressible", 1.0, 10.0), (std::vector<std::string>{"incompressible"}));
}

TEST(Svg, WidthCountsCharactersNotBytes) {
  EXPECT_EQ(svg::text_width("\u2212\u00b5", 10.0), svg::text_width("ab", 10.0));
}

TEST(Svg, DocumentIsWellFormedWhateverTheText) {
  const std::string evil = "</text><script>\"'&\x02";
  const auto pieces = parsed(svg::document(100, 50.5, evil, svg::text(1, 2, evil, {.upward = true})));
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->front().name, "svg");
  EXPECT_EQ(pieces->front().attributes.at("viewBox"), "0 0 100 50.5");
  for (const Piece& piece : *pieces) EXPECT_NE(piece.name, "script");
}

TEST(Svg, TheReaderOfTheseTestsRefusesWhatIsNotWellFormed) {
  EXPECT_TRUE(parsed("<a b=\"1\"><c/>x &amp; y</a>\n"));
  for (const char* bad :
       {"<a>", "<a></b>", "<a b=\"1\" b=\"2\"/>", "<a>x & y</a>", "<a b=1/>", "<a/>text", "<a b=\"<\"/>"})
    EXPECT_FALSE(parsed(bad)) << bad;
}

} // namespace
} // namespace matrigrate::draw
