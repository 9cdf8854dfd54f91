#include "fields/field.hpp"
#include "fields/grids.hpp"
#include "fields/picture.hpp"

#include <gtest/gtest.h>
#include <tiffio.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace matrigrate::fields {
namespace {

std::optional<PixelSize> of_text(const std::string& description) { return pixel_size({.description = description}); }

PixelSize square(double side) { return {side, side}; }

std::string ome(const std::string& attributes) {
  return "<?xml version=\"1.0\"?><OME xmlns=\"x\"><Image><Pixels ID=\"Pixels:0\" " + attributes
         + "><Channel/></Pixels></Image></OME>";
}

TEST(Scale, IsThatOfOmeXml) {
  EXPECT_EQ(of_text(ome("PhysicalSizeX=\"0.65\" PhysicalSizeY=\"0.65\"")), square(0.65)); // um by default
  EXPECT_EQ(
      of_text(ome("PhysicalSizeX='650' PhysicalSizeXUnit='nm' PhysicalSizeY='0.65' PhysicalSizeYUnit='\xc2\xb5m'")),
      square(0.65));
  EXPECT_EQ(of_text(ome("PhysicalSizeX=\"0.001\" PhysicalSizeXUnit=\"mm\"")), square(1.0));
  for (const char* nothing : {"SizeX=\"3\"", "PhysicalSizeX=\"2\" PhysicalSizeXUnit=\"pixel\"", "PhysicalSizeX=\"-1\"",
                              "PhysicalSizeX=\"nan\"", "PhysicalSizeX=\"1e999\"", "PhysicalSizeX=\"2"})
    EXPECT_EQ(of_text(ome(nothing)), std::nullopt) << nothing;
  EXPECT_EQ(of_text(ome("PhysicalSizeX=\"0.5\" PhysicalSizeY=\"0.6\"")), (PixelSize{0.5, 0.6}));
}

/// OME-XML of two Images.
std::string two_images(const std::string& first, const std::string& second) {
  return "<?xml version='1.0'?><o:OME xmlns:o='x'><OME/><o:Image><o:Pixels SizeX='30' SizeY='20' PhysicalSizeX='0.5'>"
         + first + "</o:Pixels></o:Image><o:Image><o:Pixels SizeX='15' SizeY='10' PhysicalSizeX='1'>" + second
         + "</o:Pixels></o:Image></o:OME>";
}

TEST(Scale, IsThatOfTheImageThatThePageBelongsTo) {
  const auto of_page = [](const std::string& description, std::size_t directory, std::size_t columns) {
    return pixel_size(
        {.description = description, .directory = directory, .columns = columns, .rows = columns * 2 / 3});
  };
  const std::string both = two_images("<o:TiffData IFD='0' PlaneCount='3'/>", "<o:TiffData IFD='3'/>");
  EXPECT_EQ(of_page(both, 0, 30), square(0.5));
  EXPECT_EQ(of_page(both, 2, 30), square(0.5));
  EXPECT_EQ(of_page(both, 3, 15), square(1.0));
  EXPECT_EQ(of_page(both, 4, 15), std::nullopt) << "of no Image";
  EXPECT_EQ(of_page(both, 0, 15), std::nullopt) << "a smaller version of the page";
  const std::string files = two_images("<o:TiffData IFD='0'/>", "<o:TiffData IFD='0'/>"); // each in a file of its own
  EXPECT_EQ(of_page(files, 0, 0), std::nullopt);
  EXPECT_EQ(of_page(ome("SizeX='30' PhysicalSizeX='2'"), 7, 30), square(2.0)) << "of all pages, if it is the only one";
  EXPECT_EQ(of_page(ome("SizeX='30' PhysicalSizeX='2'"), 1, 15), std::nullopt) << "a level of a pyramid";
}

TEST(Scale, IsThatOfImageJOrOfPixelsInACentimetre) {
  const StatedScale imagej{
      .description = "ImageJ=1.54f\nimages=2\nunit=micron\n", .x_resolution = 2, .y_resolution = 2};
  EXPECT_EQ(pixel_size(imagej), square(0.5));
  EXPECT_EQ(pixel_size({.description = "ImageJ=1.54f\nunit=\\u00B5m\n", .x_resolution = 4, .y_resolution = 4}),
            square(0.25));
  EXPECT_EQ(pixel_size({.description = "", .x_resolution = 5000, .y_resolution = 5000, .in_centimetres = true}),
            square(2.0));
  EXPECT_EQ(pixel_size({.description = "", .x_resolution = 1, .y_resolution = 1}), std::nullopt);
  EXPECT_EQ(pixel_size({.description = "", .x_resolution = 2, .y_resolution = 4, .in_centimetres = true}),
            (PixelSize{5000, 2500}));
}

/// Fields of TIFF files.
class ScaledFields : public testing::Test {
protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "matrigrate-scale-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  void write(const char* name, std::uint32_t side, const std::vector<float>& samples, const std::string& description) {
    TIFF* tiff = TIFFOpen((folder / name).c_str(), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, side);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, side);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, side);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    if (!description.empty()) TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, description.c_str());
    std::vector<float> copy = samples;
    TIFFWriteEncodedStrip(tiff, 0, copy.data(), static_cast<tmsize_t>(copy.size() * sizeof(float)));
    TIFFClose(tiff);
  }

  std::string what(const std::string& text) const {
    try {
      const Field field(text, folder);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder;
};

TEST_F(ScaledFields, TakeTheWidthOfAPixelFromTheFileUnlessItIsGiven) {
  write("a.tif", 2, {1, 2, 3, 4}, ome("PhysicalSizeX=\"5\""));
  EXPECT_EQ(Field("a.tif", folder).description(), "a grid of 2 x 2 nodes from (-2.5, -2.5) to (2.5, 2.5) um");
  EXPECT_EQ(Field("a.tif pixel=1", folder).description(), "a grid of 2 x 2 nodes from (-0.5, -0.5) to (0.5, 0.5) um");
  EXPECT_EQ(Field("a.tif", folder).at({-2.5, 2.5}), 1.0);
  write("oblong.tif", 2, {1, 2, 3, 4}, ome("PhysicalSizeX=\"2\" PhysicalSizeY=\"4\""));
  EXPECT_NE(what("oblong.tif").find("has pixels of 2 x 4 um; scale it so that they are square, or state"),
            std::string::npos);
  EXPECT_EQ(Field("oblong.tif pixel=3", folder).description(),
            "a grid of 2 x 2 nodes from (-1.5, -1.5) to (1.5, 1.5) um");
  write("b.tif", 2, {1, 2, 3, 4}, "");
  EXPECT_NE(what("b.tif").find("a picture needs pixel=..."), std::string::npos);
}

TEST_F(ScaledFields, TakeBlackAndWhiteAsPercentiles) {
  write("a.tif", 3, {0, 10, 20, 30, 40, 50, 60, 70, 1e6F}, "");
  const Field field("a.tif pixel=1 from=0 to=1 black=12.5% white=75%", folder); // 10 and 60
  EXPECT_NEAR(field.at({0, 1}), 0.0, 1e-12);
  EXPECT_NEAR(field.at({-1, -1}), 1.0, 1e-12);
  EXPECT_NEAR(field.at({0, 0}), 0.6, 1e-12);
  EXPECT_NE(what("a.tif pixel=1 from=0 to=1 black=1% white=101%").find("white=101% is no percentage"),
            std::string::npos);
  EXPECT_NE(what("a.tif pixel=1 from=0 to=1 black=x% white=1").find("black=x% is no percentage"), std::string::npos);
  write("even.tif", 2, {3, 3, 3, 3}, "");
  EXPECT_NE(what("even.tif pixel=1 from=0 to=1 black=1% white=99%").find("must be different"), std::string::npos);
}

TEST_F(ScaledFields, TakeTheDirectionOfStripesFromTheStructureTensor) {
  constexpr std::uint32_t side = 48;
  for (const double angle : {0.0, 25.0, 60.0, 90.0, -40.0}) {
    const double a = angle * 3.14159265358979 / 180.0;
    std::vector<float> samples;
    for (std::uint32_t row = 0; row < side; ++row)
      for (std::uint32_t column = 0; column < side; ++column) // stripes along (cos a, sin a), y upwards
        samples.push_back(static_cast<float>(std::sin(0.7 * (-std::sin(a) * column - std::cos(a) * row))));
    write("stripes.tif", side, samples, "");
    const Field field("stripes.tif pixel=0.5 direction=2", folder);
    double off = std::abs(field.at({0.3, -0.2}) - angle);
    off = std::min(off, 180.0 - off);
    EXPECT_LT(off, 1.0) << angle << " " << field.at({0.3, -0.2});
    const auto largest_at = [&](double from_middle) { // along the four sides of a square
      double largest = 0.0;
      for (double along = -from_middle; along <= from_middle; along += 0.5)
        for (const Vec2& x : {Vec2(along, from_middle), Vec2(along, -from_middle), Vec2(from_middle, along),
                              Vec2(-from_middle, along)}) {
          const double difference = std::abs(field.at(x) - angle);
          largest = std::max(largest, std::min(difference, 180.0 - difference));
        }
      return largest;
    };
    EXPECT_LT(largest_at(11.75), 13.0) << "at the edge, " << angle;
    EXPECT_LT(largest_at(9.75), 4.0) << "one radius from it, " << angle;
  }
  EXPECT_NE(what("stripes.tif pixel=0.5 direction=2 from=0 to=1").find("takes no from="), std::string::npos);
  EXPECT_NE(what("stripes.tif pixel=0.5 direction=0").find("must be from 0.25 to 50 um"), std::string::npos);
  write("even.tif", 4, std::vector<float>(16, 7.0F), "");
  EXPECT_NE(what("even.tif pixel=1 direction=1").find("is even everywhere"), std::string::npos);
  write("small.tif", 2, {1, 2, 3, 4}, "");
  EXPECT_NE(what("small.tif pixel=1 direction=1").find("is smaller than 3 x 3 pixels"), std::string::npos);
}

TEST_F(ScaledFields, DirectionsOfAPictureHaveNoSense) {
  write("angles.tif", 2, {80, -80, 80, -80}, "");
  Field field("angles.tif pixel=1", folder);
  EXPECT_NEAR(field.at({0, 0}), 0.0, 1e-9) << "as plain numbers";
  field.take_as_axes();
  EXPECT_NEAR(std::abs(field.at({0, 0})), 90.0, 1e-9);
  EXPECT_NEAR(field.at({-0.5, 0}), 80.0, 1e-9);
  write("radians.tif", 2, {1.0, 2.0, 1.0, 2.0}, "");
  Field radians("radians.tif pixel=1", folder);
  radians.scale(180.0 / std::numbers::pi);
  radians.take_as_axes();
  EXPECT_NEAR(radians.at({0, 0}), 1.5 * 180.0 / std::numbers::pi, 1e-6);
  Field of_grey("angles.tif pixel=1 from=-90 to=90 black=-80 white=80", folder);
  of_grey.take_as_axes();
  EXPECT_NEAR(std::abs(of_grey.at({0, 0})), 90.0, 1e-9) << "black and white are the same direction";
}

TEST(Directions, DoNotDependOnTheSizeOfTheNumbers) {
  Picture picture{.width = 24, .height = 24, .samples = {}, .pixel = {}, .black = {}, .white = {}};
  for (std::size_t k = 0; k < 576; ++k) {
    const auto row = k / 24;
    picture.samples.push_back(std::sin(0.4 * static_cast<double>(k % 24) + 0.5 * static_cast<double>(row)));
  }
  const std::vector<double> expected = fibre_directions(picture, 3.0);
  for (const int exponent : {-1000, -500, 500, 1000}) {
    Picture far = picture;
    for (double& sample : far.samples) sample = std::scalbn(sample, exponent);
    EXPECT_EQ(fibre_directions(far, 3.0), expected) << exponent;
  }
}

TEST(Directions, AreThoseOfTheStructureTensorSummedPixelByPixel) {
  Picture picture{.width = 13, .height = 9, .samples = {}, .pixel = {}, .black = {}, .white = {}};
  for (std::size_t k = 0; k < 117; ++k) picture.samples.push_back(static_cast<double>(k * k % 31));
  const std::vector<double> directions = fibre_directions(picture, 20.0); // wider than the picture
  EXPECT_NEAR(directions[0], -14.422117129259945, 1e-9);
  EXPECT_NEAR(directions[60], -25.38705478870733, 1e-9);
}

TEST(Samples, AreDirectionsWithoutASenseBetweenNodes) {
  const Samples axes{.origin = {0, 0}, .spacing = {1, 1}, .columns = 2, .rows = 1, .values = {80, -80}, .axes = true};
  EXPECT_NEAR(std::abs(axes.at({0.5, 0})), 90.0, 1e-9); // not 0
  EXPECT_NEAR(axes.at({0, 0}), 80.0, 1e-9);
}

} // namespace
} // namespace matrigrate::fields
