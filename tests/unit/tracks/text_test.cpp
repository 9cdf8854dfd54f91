#include "tracks/sheet.hpp"
#include "tracks/text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace matrigrate::tracks {
namespace {

using namespace std::string_literals;

Text read_text(std::string_view bytes) {
  Findings findings("f");
  Text text = decoded(bytes, findings);
  findings.raise();
  return text;
}

std::string refusal(std::string_view bytes) {
  try {
    read_text(bytes);
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "none";
}

TEST(TrackText, EncodingsAndEndsOfLines) {
  EXPECT_EQ(read_text("\xef\xbb\xbf"
                      "a\r\nb\rc\n")
                .utf8,
            "a\nb\nc\n");
  EXPECT_EQ(read_text("\xff\xfe"
                      "\xb5\0m\0"s)
                .utf8,
            "\u00b5m");
  EXPECT_EQ(read_text("\xfe\xff"
                      "\0\xb5\0m"s)
                .utf8,
            "\u00b5m");
  EXPECT_EQ(read_text("\xff\xfe"
                      "\x3d\xd8\x00\xde"s)
                .utf8,
            "\U0001F600")
      << "a surrogate pair";
  EXPECT_EQ(read_text("n\xb0 \x80").utf8, "n\u00b0 \u20ac");
  EXPECT_EQ(read_text("n\xb0").encoding, "Windows-1252");
  EXPECT_EQ(read_text("\u00b5").encoding, "UTF-8");
}

TEST(TrackText, SignsOfTypesetting) {
  EXPECT_EQ(read_text("\u22125,1\u00a0080,1\u202f080,\u20131,a\ufeffb,\u00b5,\u2026").utf8,
            "-5,1 080,1 080,-1,ab,\u00b5,\u2026");
  EXPECT_EQ(read_text("\x96"
                      "5,1\xa0"
                      "0")
                .utf8,
            "-5,1 0")
      << "of Windows-1252";
}

TEST(TrackText, WhatIsNoTextIsCalledByItsName) {
  EXPECT_EQ(refusal("PK\x03\x04..."), "f: is a workbook (.xlsx) or another archive: save the sheet as CSV");
  EXPECT_EQ(refusal("\xd0\xcf\x11\xe0..."), "f: is a workbook (.xls): save the sheet as CSV");
  EXPECT_EQ(refusal("\x1f\x8b..."), "f: is compressed (gzip): unpack it");
  EXPECT_EQ(refusal("a\n\0b"s), "f:2:1: is no text, or UTF-16 without its mark: save it as CSV in UTF-8");
  EXPECT_EQ(refusal("a\x01"), "f:1:1: has a control character: is it a text?");
}

std::vector<std::string> fields(std::string_view text, char separator) {
  const std::vector<SheetRow> rows = sheet_rows(text, separator);
  return rows.empty() ? std::vector<std::string>{} : rows[0].fields;
}

TEST(Sheet, Fields) {
  using Fields = std::vector<std::string>;
  EXPECT_EQ(fields("a, b ,c", ','), (Fields{"a", "b", "c"}));
  EXPECT_EQ(fields("\"a,1\",\"b\"\"\",", ','), (Fields{"a,1", "b\"", ""}));
  EXPECT_EQ(fields(" \ta\tb", '\t'), (Fields{"", "a", "b"})) << "ImageJ begins its lines so";
  EXPECT_EQ(fields("  a  b\tc  ", ' '), (Fields{"a", "b", "c"}));
  const std::vector<SheetRow> rows = sheet_rows("\n,,\n\"a\nb\",c\n\nd,e", ',');
  ASSERT_EQ(rows.size(), 2U) << "empty ones do not count";
  EXPECT_EQ(rows[0].line, 3U);
  EXPECT_EQ(rows[1].line, 6U);
  EXPECT_TRUE(sheet_rows("\"a,b", ',')[0].open_quote);
}

TEST(Sheet, NumbersAreDecimalNumbersAlone) {
  EXPECT_EQ(sheet_number(" +1.5e2 ", false), 150.0);
  EXPECT_EQ(sheet_number("-.5", false), -0.5);
  EXPECT_EQ(sheet_number("1,5", true), 1.5);
  for (const char* text :
       {"1_000", "\uff11\uff12", "0x10", "inf", "nan", "1e999", "1,5", "", "-", "1 000", "--1", "1.2.3", "+-1"})
    EXPECT_EQ(sheet_number(text, false), std::nullopt) << text;
  EXPECT_EQ(sheet_number("1.234,5", true), std::nullopt);
}

TEST(Sheet, SignsBetweenThousandsAreKnown) {
  for (const char* text : {"1.000,5", "1,000.5", " -12,345,678 ", "1 000", "1'000.25"})
    EXPECT_TRUE(has_thousands_sign(text)) << text;
  for (const char* text : {"1.2.3", "1000", "1,00", "12345,678.9", "", ",000", "a,000", "1,000.x", "1.000.5"})
    EXPECT_FALSE(has_thousands_sign(text)) << text;
}

TEST(Sheet, ASeparatorMayBeNamed) {
  std::string_view text = "sep=;\na;b";
  EXPECT_EQ(named_separator(text), ';');
  EXPECT_EQ(sheet_rows(text, ';')[0].line, 2U);
  text = "a;b";
  EXPECT_EQ(named_separator(text), std::nullopt);
}

} // namespace
} // namespace matrigrate::tracks
