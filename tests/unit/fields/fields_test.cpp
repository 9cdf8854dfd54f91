#include "fields/field.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "fields/formula.hpp"
#include "fields/samples.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <tiffio.h>
#include <unistd.h>

#include <cmath>
#include <stdexcept>
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
  EXPECT_NE(what(std::string(999, '(')).find("cannot be read"), std::string::npos);
  EXPECT_NE(what("").find("cannot be read"), std::string::npos);
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
  EXPECT_EQ(what("x_um,y_um,v\n0,0,1\n0,1,1\n"), "has one value of x_um only; a grid has two at least");
  EXPECT_NE(what("x_um,y_um,v\n0,0,1\n1,0,1\n3,0,1\n0,1,1\n1,1,1\n3,1,1\n").find("is no regular grid"),
            std::string::npos);
  EXPECT_NE(what("x_um,y_um,v\n0,0,1\n1,0,1\n0,1,1\n").find("has no value for the node (1, 1) um"), std::string::npos);
  EXPECT_NE(what("x_um,y_um,v\n0,0,1\n1,0,1\n0,1,1\n1,1,1\n1,1,2\n").find("the node (1, 1) um twice"),
            std::string::npos);
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
  EXPECT_NE(what("a.png size=2").find("\"size=2\" is not known"), std::string::npos);
  write_file(folder / "b.png", "\x89PNG and then nothing");
  EXPECT_NE(what("b.png pixel=1 from=0 to=1").find("b.png: cannot be read as PNG"), std::string::npos);
  write_file(folder / "c.tif", "nothing");
  EXPECT_NE(what("c.tif pixel=1 from=0 to=1").find("c.tif: cannot be read as TIFF"), std::string::npos);
}

TEST_F(FieldFiles, ATiffIsReadAsItsBrightness) {
  TIFF* tiff = TIFFOpen((folder / "a.tif").c_str(), "w");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 2);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  std::vector<unsigned char> row{0, 255};
  TIFFWriteScanline(tiff, row.data(), 0, 0);
  TIFFClose(tiff);
  const Field field("a.tif pixel=1 from=0 to=1", folder);
  EXPECT_NEAR(field.at({-0.5, 0.0}), 0.0, 1e-9);
  EXPECT_NEAR(field.at({0.5, 0.0}), 1.0, 1e-9);
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

} // namespace
} // namespace matrigrate::fields
