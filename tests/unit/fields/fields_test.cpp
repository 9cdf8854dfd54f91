#include "fields/field.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "fields/file_words.hpp"
#include "fields/grids.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <tiffio.h>
#include <unistd.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace matrigrate::fields {
namespace {

std::string complaint(const auto& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

/// A field by its formula.
struct Formula : Field {
  explicit Formula(const std::string& text) : Field(text, "") {}
};

TEST(Formula, IsComputedAtPoints) {
  const Formula f("200 + 2*x - y^2 + r");
  EXPECT_DOUBLE_EQ(f.at({3.0, 4.0}), 200.0 + 6.0 - 16.0 + 5.0);
  EXPECT_DOUBLE_EQ(Formula("x > 0 && y > 0 ? 1 : 0").at({1.0, -1.0}), 0.0);
  EXPECT_DOUBLE_EQ(Formula("max(0, min(1, abs(x)/10))").at({-5.0, 0.0}), 0.5);
  EXPECT_TRUE(std::isnan(Formula("sqrt(x)").at({-1.0, 0.0})));
  EXPECT_TRUE(std::isinf(Formula("1/x").at({0.0, 0.0})));
}

TEST(Formula, SaysWhatCannotBeRead) {
  const auto what = [](const std::string& text) { return complaint([&] { Formula f(text); }); };
  EXPECT_NE(what("200 +").find("cannot be read as a formula in x, y and r"), std::string::npos);
  EXPECT_NE(what("200 + z").find("at character 7"), std::string::npos) << what("200 + z");
  EXPECT_NE(what("while(1)").find("cannot be read"), std::string::npos);
  EXPECT_NE(what("x = 3; x").find("cannot be read"), std::string::npos) << "no memory";
  EXPECT_NE(what(std::string(1'000'000, '(')).find("allowed are 1000"), std::string::npos);
  EXPECT_NE(what(std::string(999, '(')).find("nested deeper than 200"), std::string::npos);
  EXPECT_NE(what(std::string(999, '-')).find("nested deeper than 200"), std::string::npos);
  EXPECT_EQ(Formula(std::string(190, '(') + "2" + std::string(190, ')')).at({0.0, 0.0}), 2.0);
  EXPECT_NE(what("").find("cannot be read"), std::string::npos);
}

TEST(Formula, RefusesDecimalCommasAndAssignments) {
  const auto what = [](const std::string& text) { return complaint([&] { Formula f(text); }); };
  EXPECT_NE(what("x + 200,5*y").find("at character 8: a comma stands outside of a function; write 200.5 with"),
            std::string::npos)
      << what("x + 200,5*y");
  EXPECT_NE(what("max(1, 2) + (1, x)").find("at character 15: a comma stands outside of a function; a formula has"),
            std::string::npos);
  EXPECT_NE(what("x = 0 ? 100 : 300").find("at character 3: = would set a value; write == to compare"),
            std::string::npos);
  EXPECT_NE(what("x => 0").find("at character 3"), std::string::npos);
  EXPECT_DOUBLE_EQ(Formula("x == 1 && y != 1 && x <= 1 && y >= 0 ? max((x + 1)*2, min(1, 2), 3) : 0").at({1.0, 0.0}),
                   4.0);
}

TEST(Samples, AreBilinearBetweenNodesAndConstantBeyond) {
  const Samples s = samples_from_csv("x_um,y_um,E_Pa\n0,0,1\n2,0,3\n0,4,5\n2,4,11\n", "");
  EXPECT_DOUBLE_EQ(s.at({0.0, 0.0}), 1.0);
  EXPECT_DOUBLE_EQ(s.at({2.0, 4.0}), 11.0);
  EXPECT_DOUBLE_EQ(s.at({1.0, 2.0}), 5.0);
  EXPECT_DOUBLE_EQ(s.at({-9.0, -9.0}), 1.0);
  EXPECT_DOUBLE_EQ(s.at({9.0, 0.0}), 3.0);
}

TEST(Samples, RefuseWhatIsNoRegularGrid) {
  const auto what = [](const char* text) { return complaint([&] { samples_from_csv(text, ""); }); };
  EXPECT_EQ(what("a,b,c\n1,2,3\n"), "has no column x_um; its header is \"a,b,c\"");
  EXPECT_EQ(what("x_um,y_um\n"), "has no third column");
  EXPECT_EQ(what("x_um,y_um,v\n"), "has no rows");
  EXPECT_EQ(what("x_um,y_um,v\n0,0,nan\n"), "line 2: \"nan\" is no finite number");
  EXPECT_EQ(what("x_um,y_um,v\n0,0\n"), "line 2: has 2 fields, its header 3");
  EXPECT_EQ(what("x_um,y_um,v\n0,0,1\n0,1,1\n"), "has only one value of x_um; a grid needs at least two");
  EXPECT_NE(what("x_um,y_um,v\n0,0,1\n1,0,1\n3,0,1\n0,1,1\n1,1,1\n3,1,1\n").find("is no regular grid"),
            std::string::npos);
  EXPECT_NE(what("x_um,y_um,v\n0,0,1\n1.01,0,1\n2,0,1\n0,1,1\n1.01,1,1\n2,1,1\n").find("is no regular grid: x_um is"),
            std::string::npos);
  EXPECT_EQ(what("x_um,y_um,v\n0,0,1\n1.0000001,0,1\n2,0,1\n0,1,1\n1.0000001,1,1\n2,1,1\n"), "") << "rounded";
  EXPECT_NE(what("x_um,y_um,v\n0,0,1\n1,0,1\n0,1,1\n").find("has no value for the node (1, 1) um"), std::string::npos);
  EXPECT_NE(what("x_um,y_um,v\n0,0,1\n1,0,1\n0,1,1\n1,1,1\n1,1,2\n").find("the node (1, 1) um twice"),
            std::string::npos);
}

TEST(Samples, ReadTheHeadersThatProgramsWriteAndSayWhichAreNoCommas) {
  const auto what = [](const char* text) { return complaint([&] { samples_from_csv(text, ""); }); };
  EXPECT_EQ(samples_from_csv("\xef\xbb\xbf\"x_um\",\"y_um\",\"E\"\r\n0,0,1\n2,0,3\n0,4,5\n2,4,11\n", "E").at({0, 4}),
            5.0);
  EXPECT_EQ(what("x_um;y_um;v\n0;0;1,5\n"),
            "has semicolons between its columns; write commas there, and points in numbers");
  EXPECT_EQ(what("x_um\ty_um\tv\n0\t0\t1\n"),
            "has tabs between its columns; write commas there, and points in numbers");
  EXPECT_EQ(what("v,x_um,y_um\n"), "has y_um as its third column; name the column of the values with column=");
  EXPECT_EQ(what("x_um,y_um,v,x_um\n"), "has two columns x_um");
  EXPECT_EQ(what("x_um,y_um,v\n-1e308,0,1\n1e308,0,1\n"), "has values of x_um too far apart");
}

TEST(Samples, OfADiagonalAskForNoMoreMemoryThanItHasRows) {
  std::string diagonal = "x_um,y_um,v\n";
  for (int k = 0; k < 300'000; ++k) diagonal += std::to_string(k) + "," + std::to_string(k) + ",1\n"; // 720 GB of nodes
  EXPECT_EQ(
      complaint([&] { samples_from_csv(diagonal, ""); }),
      "has no value for the node (1, 0) um: a grid of 300000 x 300000 nodes has 90000000000 rows, this has 300000");
}

class FieldFiles : public testing::Test {
protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "matrigrate-fields-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::string what(const std::string& text) const {
    return complaint([&] { Field field(text, folder); });
  }

  std::filesystem::path folder;
};

TEST_F(FieldFiles, APictureIsGreyFromBlackToWhiteWithItsCentreWhereItIsPut) {
  const std::vector<png_byte> pixels{0, 51, 255, 102, 153, 204}; // 3 wide, 2 high; the first row is the upper one
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = 3;
  image.height = 2;
  image.format = PNG_FORMAT_GRAY;
  ASSERT_NE(png_image_write_to_file(&image, (folder / "a.png").c_str(), 0, pixels.data(), 0, nullptr), 0);
  const Field field("a.png pixel=2 from=100 to=200 x=10", folder);
  EXPECT_NEAR(field.at({8.0, 1.0}), 100.0, 1e-9);
  EXPECT_NEAR(field.at({12.0, 1.0}), 200.0, 1e-9);
  EXPECT_NEAR(field.at({8.0, -1.0}), 140.0, 1e-9);
  EXPECT_NEAR(field.at({10.0, 1.0}), 120.0, 1e-9);
  EXPECT_EQ(field.description(), "a grid of 3 x 2 nodes from (8, -1) to (12, 1) um");
  EXPECT_NE(what("a.png").find("a picture needs pixel=..."), std::string::npos);
  EXPECT_NE(what("a.png pixel=0 from=0 to=1").find("above 0"), std::string::npos);
  EXPECT_NE(what("a.png pixel=x from=0 to=1").find("pixel=x is no number"), std::string::npos);
  EXPECT_NE(what("a.png size=2").find("\"size=\" is not known"), std::string::npos);
  write_file(folder / "b.png", "\x89PNG and then nothing");
  EXPECT_NE(what("b.png pixel=1 from=0 to=1").find("b.png: cannot be read as PNG"), std::string::npos);
  write_file(folder / "c.tif", "nothing");
  EXPECT_NE(what("c.tif pixel=1 from=0 to=1").find("c.tif: is neither PNG nor TIFF"), std::string::npos);
}

TEST_F(FieldFiles, FloatingPointIsTakenAsItIsOrBetweenTwoOfItsValues) {
  TIFF* tiff = TIFFOpen((folder / "a.tif").c_str(), "w");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 2);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  std::vector<float> row{120.5F, 380.0F};
  TIFFWriteScanline(tiff, row.data(), 0, 0);
  TIFFClose(tiff);
  EXPECT_EQ(Field("a.tif pixel=1", folder).at({-0.5, 0.0}), 120.5);
  EXPECT_EQ(Field("a.tif pixel=1", folder).at({0.5, 0.0}), 380.0);
  EXPECT_NEAR(Field("a.tif pixel=1 from=1 to=3 black=300 white=400", folder).at({0.5, 0.0}), 2.6, 1e-12);
  EXPECT_NE(what("a.tif pixel=1 from=0 to=1").find("a.tif: its samples are of floating point, from 120.5 to 380"),
            std::string::npos);
}

TEST_F(FieldFiles, BlackAndWhiteMayBeOtherSamplesThanTheEndsOfTheScale) {
  const std::vector<png_byte> pixels{0, 255};
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = 2;
  image.height = 1;
  image.format = PNG_FORMAT_GRAY;
  ASSERT_NE(png_image_write_to_file(&image, (folder / "a.png").c_str(), 0, pixels.data(), 0, nullptr), 0);
  const Field field("a.png pixel=1 from=10 to=20 black=55 white=155", folder);
  EXPECT_NEAR(field.at({-0.5, 0.0}), 4.5, 1e-12) << "on the line beyond black";
  EXPECT_NEAR(field.at({0.5, 0.0}), 30.0, 1e-12);
  EXPECT_NE(what("a.png pixel=1 from=0 to=1 black=5 white=5").find("must be different"), std::string::npos);
}

TEST_F(FieldFiles, AreFoundInFoldersWithSpaces) {
  const std::filesystem::path there = folder / "sp ace \"a\"";
  std::filesystem::create_directory(there);
  write_file(there / "my E.csv", "x_um,y_um,E\n0,0,1\n1,0,1\n0,1,1\n1,1,1\n");
  const Field field("my E.csv", there);
  EXPECT_TRUE(names_one_file(field.text())) << field.text();
  EXPECT_FALSE(names_one_file("my E.csv hash=00"));
  EXPECT_EQ(Field(field.text(), "/nowhere").text(), field.text());
  std::filesystem::remove(there / "my E.csv");
  EXPECT_THROW(Field(field.text(), ""), InputOutputError);
}

TEST_F(FieldFiles, TheTextOfAFileHoldsItsPathAndFingerprint) {
  write_file(folder / "E.csv", "x_um,y_um,a,b\n0,0,1,5\n1,0,1,5\n0,1,1,5\n1,1,1,5\n");
  const Field field("E.csv column=b", folder);
  EXPECT_DOUBLE_EQ(field.at({0.5, 0.5}), 5.0);
  EXPECT_NE(field.text().find((folder / "E.csv").string() + " column=b hash="), std::string::npos) << field.text();
  EXPECT_EQ(Field(field.text(), "/nowhere").text(), field.text()) << "the same from any folder";
  write_file(folder / "E.csv", "x_um,y_um,a,b\n0,0,1,5\n1,0,1,5\n0,1,1,5\n1,1,1,6\n");
  EXPECT_NE(what(field.text()).find("E.csv has changed: its fingerprint is"), std::string::npos);
  EXPECT_NE(what("E.csv column=c").find("has no column c"), std::string::npos);
  EXPECT_THROW(Field("none.csv", folder), InputOutputError);
  EXPECT_EQ(Field("1 + x", folder).text(), "1 + x");
}

TEST_F(FieldFiles, AreReadOnceByThoseWhoShareGrids) {
  write_file(folder / "E.csv", "x_um,y_um,a,b\n0,0,1,5\n1,0,1,5\n0,1,1,5\n1,1,1,5\n");
  Grids grids, others;
  const FileWords a = *file_words("E.csv column=a"), b = *file_words("E.csv column=b");
  const NamedGrid first = grids.of(a, folder);
  EXPECT_EQ(grids.of(a, folder).grid, first.grid);
  EXPECT_EQ(grids.of(*file_words(first.text), "/nowhere").grid, first.grid) << "by its whole path";
  EXPECT_NE(grids.of(b, folder).grid, first.grid) << "another column";
  EXPECT_NE(others.of(a, folder).grid, first.grid) << "nothing is shared by the whole program";
  write_file(folder / "E.csv", "x_um,y_um,a,b\n0,0,1,5\n1,0,1,5\n0,1,1,5\n1,1,2,5\n");
  EXPECT_EQ(grids.of(a, folder).grid->at({1.0, 1.0}), 2.0) << "a file that has changed";
}

} // namespace
} // namespace matrigrate::fields
