#include "fields/file_words.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace matrigrate::fields {
namespace {

std::string fault_of(const std::string& text) {
  try {
    file_words(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

std::string name_of(const std::string& text) {
  const auto words = file_words(text);
  return words ? words->name.string() : "";
}

TEST(FileWords, ReachUpToTheEndingOrStandInQuotes) {
  EXPECT_EQ(name_of("stiff.csv"), "stiff.csv");
  EXPECT_EQ(name_of("  a b/my  file.PNG pixel=1 from=0 to=1"), "a b/my  file.PNG");
  EXPECT_EQ(name_of("/sp ace/stiff.csv column=E"), "/sp ace/stiff.csv");
  EXPECT_EQ(name_of("v1.png old/stiff.ome.TIFF pixel=1"), "v1.png old/stiff.ome.TIFF");
  EXPECT_EQ(name_of("'x=1 y=2/a.tif' pixel=1"), "x=1 y=2/a.tif");
  EXPECT_EQ(name_of(R"("say \"a\" b.csv" column='E (Pa)')"), "say \"a\" b.csv");
  EXPECT_EQ(file_words("a.csv column=\"E (Pa)\"")->word("column"), "E (Pa)");
}

TEST(FileWords, AreNotThoseOfAFormula) {
  for (const char* formula : {"", "200", "2.e5", "x*2.E10 + 1", "1.5*x", "abs(y) < 5 ? 0 : 1", "x == 3", "x =3",
                              "max(0.5,r)", "2.f", "x/y", "-.5e2*x"})
    EXPECT_FALSE(file_words(formula)) << formula;
}

TEST(FileWords, OfOtherKindsAreRefusedAsFiles) {
  for (const char* name : {"a.jpg", "a.jpeg", "my a.zarr", "a.h5", "./a", "/data/b"})
    EXPECT_EQ(fault_of(name), std::string("the file \"") + name
                                  + "\" cannot be read; PNG (.png), TIFF (.tif, .tiff) and CSV (.csv) can");
  EXPECT_EQ(fault_of("a.png pixel=1 pixel=2"), "pixel= is given twice");
  EXPECT_EQ(fault_of("a.png size=2"),
            "\"size=\" is not known; allowed after the file: pixel=..., from=..., to=..., "
            "black=..., white=..., direction=..., x=..., y=..., page=..., channel=..., hash=...");
  EXPECT_NE(fault_of("a.csv 5").find("\"5\" is not known; allowed after the file: column=..., hash=..."),
            std::string::npos);
  EXPECT_NE(fault_of("a.csv * 2").find("\"*\" is not known"), std::string::npos);
  EXPECT_EQ(fault_of("a.png pixel="), "pixel= has no value");
  EXPECT_EQ(fault_of("\"a.png"), "has a quote that does not end: \"a.png");
}

TEST(FileWords, AreReadBackFromTheirText) {
  const auto words = file_words("'a \"b\".png' pixel=0.5 from=1 to=2 hash=00");
  const std::string text = words->text("/sp ace/a \"b\\\".png", "ff");
  EXPECT_EQ(file_words(text)->name.string(), "/sp ace/a \"b\\\".png") << text;
  EXPECT_EQ(file_words(text)->word("hash"), "ff");
  EXPECT_EQ(file_words(text)->text(file_words(text)->name, "ff"), text);
  EXPECT_EQ(file_words("a.csv")->text("/plain/a.csv", "ff"), "/plain/a.csv hash=ff");
}

TEST(FileWords, HaveNumbers) {
  const auto words = file_words("a.png pixel=0,5 x=1e2 y=nan page=0 channel=2");
  EXPECT_EQ(words->number("x"), 100.0);
  EXPECT_FALSE(words->number("from"));
  EXPECT_THROW(words->number("pixel"), std::invalid_argument);
  EXPECT_THROW(words->number("y"), std::invalid_argument);
  EXPECT_THROW(words->count("page"), std::invalid_argument);
  EXPECT_EQ(words->count("channel"), 2U);
}

} // namespace
} // namespace matrigrate::fields
