#include "fields/picture.hpp"

#include "base/file.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <tiffio.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace matrigrate::fields {
namespace {

/// A PNG of one row, with a gamma of 1 if that is wanted.
std::string png_of(int colour_type, int bits, const std::vector<std::uint16_t>& samples, std::size_t channels,
                   bool gamma = false) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp p, png_bytep data, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(data), size);
      },
      [](png_structp) {});
  png_set_IHDR(png, info, static_cast<png_uint_32>(samples.size() / channels), 1, bits, colour_type, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (gamma) png_set_gAMA(png, info, 1.0);
  png_write_info(png, info);
  std::vector<png_byte> row;
  for (const std::uint16_t sample : samples) {
    if (bits == 16) row.push_back(static_cast<png_byte>(sample >> 8));
    row.push_back(static_cast<png_byte>(sample & 0xff));
  }
  png_write_row(png, row.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

struct TiffPage {
  std::uint32_t width = 1, height = 1;
  std::uint16_t channels = 1, photometric = PHOTOMETRIC_MINISBLACK, format = SAMPLEFORMAT_UINT, alpha = 0,
                planar = PLANARCONFIG_CONTIG, orientation = ORIENTATION_TOPLEFT;
  std::uint32_t tile = 0; ///< width of square tiles; 0 for rows
};

class Pictures : public testing::Test {
protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "matrigrate-pictures-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// Each page by its samples, pixel by pixel; with separate channels one channel after the other.
  template <class Sample>
  std::string tiff_of(const TiffPage& page, const std::vector<std::vector<Sample>>& pages) const {
    const std::string file = (folder / "made.tif").string();
    TIFF* tiff = TIFFOpen(file.c_str(), "w");
    for (std::vector<Sample> samples : pages) {
      TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, page.width);
      TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, page.height);
      TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8 * sizeof(Sample));
      TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, page.channels);
      TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, page.format);
      TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, page.photometric);
      TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, page.planar);
      TIFFSetField(tiff, TIFFTAG_ORIENTATION, page.orientation);
      if (page.alpha != 0) TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &page.alpha);
      if (page.tile != 0) {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, page.tile);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, page.tile);
        std::vector<Sample> tile(std::size_t{page.tile} * page.tile);
        for (std::uint32_t top = 0; top < page.height; top += page.tile)
          for (std::uint32_t left = 0; left < page.width; left += page.tile) {
            for (std::uint32_t k = 0; k < tile.size(); ++k) {
              const std::uint32_t row = top + k / page.tile, column = left + k % page.tile;
              tile[k] = row < page.height && column < page.width ? samples[row * page.width + column] : Sample(99);
            }
            TIFFWriteTile(tiff, tile.data(), left, top, 0, 0);
          }
      } else {
        const std::size_t row_samples = page.planar == PLANARCONFIG_CONTIG ? page.width * page.channels : page.width;
        for (std::uint32_t k = 0; k < samples.size() / row_samples; ++k)
          TIFFWriteScanline(tiff, samples.data() + k * row_samples, k % page.height,
                            static_cast<std::uint16_t>(k / page.height));
      }
      TIFFWriteDirectory(tiff);
    }
    TIFFClose(tiff);
    return read_file(file, 1U << 20U);
  }

  std::filesystem::path folder;
};

using Numbers = std::vector<double>;
using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::uint16_t>;

/// Of full scale.
Numbers levels_of(const std::string& bytes, const PictureChoice& choice = {}) {
  const Picture picture = read_picture(bytes, choice);
  Numbers levels;
  for (const double sample : picture.samples)
    levels.push_back((sample - *picture.black) / (*picture.white - *picture.black));
  return levels;
}

std::string refusal(const std::string& bytes, const PictureChoice& choice = {}) {
  try {
    read_picture(bytes, choice);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST_F(Pictures, OfAllFormatsGiveTheStoredSampleOverFullScale) {
  const Numbers eight{0.0, 64 / 255.0, 128 / 255.0, 1.0};
  EXPECT_EQ(levels_of(png_of(PNG_COLOR_TYPE_GRAY, 8, {0, 64, 128, 255}, 1)), eight);
  EXPECT_EQ(levels_of(png_of(PNG_COLOR_TYPE_GRAY, 8, {0, 64, 128, 255}, 1, true)), eight);
  EXPECT_EQ(levels_of(tiff_of<std::uint8_t>({.width = 4}, {{0, 64, 128, 255}})), eight);
  const Numbers sixteen{0.0, 8192 / 65535.0, 32768 / 65535.0, 1.0};
  EXPECT_EQ(levels_of(png_of(PNG_COLOR_TYPE_GRAY, 16, {0, 8192, 32768, 65535}, 1)), sixteen);
  EXPECT_EQ(levels_of(png_of(PNG_COLOR_TYPE_GRAY, 16, {0, 8192, 32768, 65535}, 1, true)), sixteen);
  EXPECT_EQ(levels_of(tiff_of<std::uint16_t>({.width = 4}, {{0, 8192, 32768, 65535}})), sixteen);
  EXPECT_EQ(levels_of(tiff_of<std::uint32_t>({.width = 2}, {{0, 1U << 31U}})),
            (Numbers{0.0, 2147483648.0 / 4294967295.0}));
}

TEST_F(Pictures, OfColoursHaveOneWeighting) {
  const std::vector<std::uint16_t> red_green_blue_grey{255, 0, 0, 0, 255, 0, 0, 0, 255, 77, 77, 77};
  const Numbers expected{0.2126, 0.7152, 0.0722, 77 / 255.0};
  const std::string png = png_of(PNG_COLOR_TYPE_RGB, 8, red_green_blue_grey, 3, true);
  const TiffPage page{.width = 4, .channels = 3, .photometric = PHOTOMETRIC_RGB};
  const std::string tiff = tiff_of<std::uint8_t>(page, {Bytes(red_green_blue_grey.begin(), red_green_blue_grey.end())});
  for (const std::string& bytes : {png, tiff}) {
    const Numbers levels = levels_of(bytes);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(levels[k], expected[k], 1e-15);
    EXPECT_EQ(levels[3], expected[3]) << "a grey in colours is that grey";
    EXPECT_EQ(levels_of(bytes, {.page = {}, .channel = 2}), (Numbers{0.0, 1.0, 0.0, 77 / 255.0}));
    EXPECT_EQ(refusal(bytes, {.page = {}, .channel = 4}), "has no channel 4: it has 3");
  }
  const Words wide{65535, 0, 0, 300, 300, 300};
  EXPECT_EQ(levels_of(png_of(PNG_COLOR_TYPE_RGB, 16, wide, 3)),
            levels_of(tiff_of<std::uint16_t>({.width = 2, .channels = 3, .photometric = PHOTOMETRIC_RGB}, {wide})));
}

TEST_F(Pictures, OfFloatingPointAreAsTheyAre) {
  const Picture picture =
      read_picture(tiff_of<float>({.width = 3, .format = SAMPLEFORMAT_IEEEFP}, {{-1.5F, 0.25F, 1e6F}}), {});
  EXPECT_EQ(picture.samples, (Numbers{-1.5, 0.25, 1e6}));
  EXPECT_FALSE(picture.black);
  EXPECT_EQ(read_picture(tiff_of<double>({.width = 1, .format = SAMPLEFORMAT_IEEEFP}, {{0.1}}), {}).samples,
            Numbers{0.1});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(refusal(tiff_of<float>({.width = 2, .format = SAMPLEFORMAT_IEEEFP}, {{1.0F, nan}}))
                .find("no finite number in the pixel of column 2 and row 1"),
            std::string::npos);
}

TEST_F(Pictures, AskForAPageAndAChannel) {
  const std::string two = tiff_of<std::uint8_t>({.width = 2}, {{1, 2}, {3, 4}});
  EXPECT_EQ(refusal(two), "has 2 pages: choose one with page=1 to page=2");
  EXPECT_EQ(read_picture(two, {.page = 2, .channel = {}}).samples, (Numbers{3, 4}));
  EXPECT_EQ(refusal(two, {.page = 3, .channel = {}}), "has no page 3: it has 2");
  const std::string png = png_of(PNG_COLOR_TYPE_GRAY, 8, {9}, 1);
  EXPECT_EQ(refusal(png, {.page = 2, .channel = {}}), "has no page 2: a PNG has one");
  EXPECT_EQ(read_picture(png, {.page = 1, .channel = 1}).samples, Numbers{9});
  const std::string channels = tiff_of<std::uint8_t>({.width = 1, .channels = 5}, {{1, 2, 3, 4, 5}});
  EXPECT_EQ(refusal(channels), "has 5 channels: choose one with channel=1 to channel=5");
  EXPECT_EQ(read_picture(channels, {.page = {}, .channel = 4}).samples, Numbers{4});
}

/// What is set for each page besides.
using Tags = std::vector<std::function<void(TIFF*)>>;

/// Grey pages of 8 bits, of one value each.
std::string pages_of(const std::filesystem::path& folder, const std::vector<std::array<std::uint32_t, 2>>& sizes,
                     const Tags& tags, const char* mode = "w") {
  const std::string file = (folder / "pages.tif").string();
  TIFF* tiff = TIFFOpen(file.c_str(), mode);
  for (std::size_t page = 0; page < sizes.size(); ++page) {
    const auto [width, height] = sizes[page];
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    tags[page](tiff);
    Bytes row(width, static_cast<std::uint8_t>(page + 1));
    for (std::uint32_t k = 0; k < height; ++k) TIFFWriteScanline(tiff, row.data(), k, 0);
    TIFFWriteDirectory(tiff);
  }
  TIFFClose(tiff);
  return read_file(file, 1U << 20U);
}

TEST_F(Pictures, HaveTheScaleOfTheirPage) {
  const auto in_centimetres = [](float resolution, std::uint32_t kind = 0) {
    return [=](TIFF* tiff) {
      TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_CENTIMETER);
      TIFFSetField(tiff, TIFFTAG_XRESOLUTION, resolution);
      TIFFSetField(tiff, TIFFTAG_YRESOLUTION, resolution);
      TIFFSetField(tiff, TIFFTAG_SUBFILETYPE, kind);
    };
  };
  const auto nothing = [](TIFF*) {};
  const auto width_of = [](const std::string& bytes, std::size_t page) -> std::optional<double> {
    const auto pixel = read_picture(bytes, {.page = page, .channel = {}}).pixel;
    return pixel ? std::optional(pixel->width) : std::nullopt;
  };
  const std::string plain =
      pages_of(folder, {{6, 4}, {3, 2}, {3, 2}}, {in_centimetres(20000), in_centimetres(10000), nothing});
  EXPECT_EQ(width_of(plain, 1), 0.5);
  EXPECT_EQ(width_of(plain, 2), 1.0);
  EXPECT_EQ(width_of(plain, 3), std::nullopt);
  const std::string pyramid = pages_of(folder, {{6, 4}, {3, 2}, {3, 2}},
                                       {in_centimetres(20000), in_centimetres(20000, FILETYPE_REDUCEDIMAGE),
                                        in_centimetres(10000, FILETYPE_REDUCEDIMAGE)});
  EXPECT_EQ(width_of(pyramid, 2), std::nullopt) << "a copy of that of the whole picture";
  EXPECT_EQ(width_of(pyramid, 3), 1.0);
  const auto imagej = [](TIFF* tiff) {
    TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, "ImageJ=1.54f\nimages=2\nunit=um\n");
    TIFFSetField(tiff, TIFFTAG_XRESOLUTION, 2.0F);
    TIFFSetField(tiff, TIFFTAG_YRESOLUTION, 2.0F);
  };
  const std::string stack = pages_of(folder, {{6, 4}, {6, 4}}, {imagej, nothing});
  EXPECT_EQ(width_of(stack, 2), 0.5) << "of the first page, which describes all";
}

/// A TIFF of 2 x 2 pixels of 16 bits in one strip, with more behind it. ImageJ writes stacks of more than 4 GB so.
std::string one_directory(bool big_endian, std::uint16_t compression, const std::string& description,
                          const Words& samples) {
  std::string bytes = big_endian ? "MM" : "II";
  const auto put = [&](std::uint32_t value, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k) bytes += static_cast<char>(value >> 8 * (big_endian ? size - 1 - k : k));
  };
  constexpr std::uint32_t entries = 9, text = 8 + 2 + 12 * entries + 4;
  const std::uint32_t strip = text + static_cast<std::uint32_t>(description.size()) + 1;
  put(42, 2);
  put(8, 4);
  put(entries, 2);
  const auto entry = [&](std::uint32_t tag, std::uint32_t value) {
    put(tag, 2);
    put(4, 2);
    put(1, 4);
    put(value, 4);
  };
  entry(TIFFTAG_IMAGEWIDTH, 2);
  entry(TIFFTAG_IMAGELENGTH, 2);
  entry(TIFFTAG_BITSPERSAMPLE, 16);
  entry(TIFFTAG_COMPRESSION, compression);
  entry(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  put(TIFFTAG_IMAGEDESCRIPTION, 2);
  put(2, 2);
  put(static_cast<std::uint32_t>(description.size()) + 1, 4);
  put(text, 4);
  entry(TIFFTAG_STRIPOFFSETS, strip);
  entry(TIFFTAG_ROWSPERSTRIP, 2);
  entry(TIFFTAG_STRIPBYTECOUNTS, 8);
  put(0, 4);
  bytes += description + '\0';
  for (const std::uint16_t sample : samples) put(sample, 2);
  return bytes;
}

TEST_F(Pictures, OfAStackInOneDirectoryAreChosenByTheirPage) {
  const std::string three = "ImageJ=1.54f\nimages=3\nslices=3\n";
  const Words planes{1, 2, 3, 4, 500, 600, 700, 800, 9, 10, 11, 65535};
  for (const bool big_endian : {false, true}) {
    const std::string bytes = one_directory(big_endian, COMPRESSION_NONE, three, planes);
    EXPECT_EQ(refusal(bytes), "has 3 pages: choose one with page=1 to page=3");
    EXPECT_EQ(read_picture(bytes, {.page = 1, .channel = {}}).samples, (Numbers{1, 2, 3, 4}));
    EXPECT_EQ(read_picture(bytes, {.page = 2, .channel = {}}).samples, (Numbers{500, 600, 700, 800}));
    EXPECT_EQ(read_picture(bytes, {.page = 3, .channel = {}}).samples, (Numbers{9, 10, 11, 65535}));
    EXPECT_EQ(refusal(bytes, {.page = 4, .channel = {}}), "has no page 4: it has 3");
    EXPECT_EQ(refusal(bytes.substr(0, bytes.size() - 1), {.page = 3, .channel = {}}),
              "is a stack in one directory, whose planes do not follow one another uncompressed: save it as separate "
              "pages");
  }
  EXPECT_EQ(read_picture(one_directory(false, COMPRESSION_NONE, "images=3", planes), {}).samples, (Numbers{1, 2, 3, 4}))
      << "not of ImageJ";
}

TEST_F(Pictures, WithALossyCompressionAreRefusedAsTheyAreElsewhere) {
  for (const auto& [compression, name] :
       {std::pair(COMPRESSION_JPEG, "JPEG"), std::pair(COMPRESSION_OJPEG, "JPEG"), std::pair(COMPRESSION_WEBP, "WebP"),
        std::pair(COMPRESSION_JP2000, "JPEG 2000")})
    EXPECT_EQ(refusal(one_directory(false, static_cast<std::uint16_t>(compression), "", {1, 2, 3, 4})),
              std::string("is compressed as ") + name
                  + ", which changes the numbers, so there is no way to read it; save the original without "
                    "compression, or with deflate or LZW");
}

TEST_F(Pictures, AreRefusedIfTransparentAndTakenIfOpaque) {
  const TiffPage page{.width = 2, .channels = 4, .photometric = PHOTOMETRIC_RGB, .alpha = EXTRASAMPLE_UNASSALPHA};
  for (const bool opaque : {true, false}) {
    const std::uint8_t last = opaque ? 255 : 254;
    const Bytes samples{10, 10, 10, 255, 20, 20, 20, last};
    const Words words(samples.begin(), samples.end());
    for (const std::string& bytes :
         {png_of(PNG_COLOR_TYPE_RGB_ALPHA, 8, words, 4), tiff_of<std::uint8_t>(page, {samples})}) {
      if (opaque)
        EXPECT_EQ(read_picture(bytes, {}).samples, (Numbers{10, 20}));
      else
        EXPECT_NE(refusal(bytes).find("has transparent pixels"), std::string::npos) << refusal(bytes);
      EXPECT_EQ(read_picture(bytes, {.page = {}, .channel = 1}).samples, (Numbers{10, 20}));
    }
  }
  EXPECT_NE(refusal(png_of(PNG_COLOR_TYPE_GRAY_ALPHA, 16, {1, 65534}, 2)).find("channel=1 to channel=2"),
            std::string::npos);
}

TEST_F(Pictures, OfTiffAreReadHoweverTheyAreStored) {
  Bytes samples(20 * 18);
  for (std::size_t k = 0; k < samples.size(); ++k) samples[k] = static_cast<std::uint8_t>(k % 251);
  const Numbers expected(samples.begin(), samples.end());
  const auto read = [&](const TiffPage& page) { return read_picture(tiff_of<std::uint8_t>(page, {samples}), {}); };
  EXPECT_EQ(read({.width = 20, .height = 18}).samples, expected);
  EXPECT_EQ(read({.width = 20, .height = 18, .tile = 16}).samples, expected);
  const Picture turned = read({.width = 20, .height = 18, .orientation = ORIENTATION_BOTRIGHT});
  EXPECT_EQ(turned.samples, Numbers(expected.rbegin(), expected.rend()));
  const Picture mirrored = read({.width = 20, .height = 18, .orientation = ORIENTATION_BOTLEFT});
  EXPECT_EQ(mirrored.samples[0], expected[17 * 20]);
  const Picture leftwards = read({.width = 20, .height = 18, .orientation = ORIENTATION_TOPRIGHT});
  EXPECT_EQ(leftwards.samples[0], expected[19]);
  EXPECT_EQ(leftwards.samples[20], expected[39]);
  const Picture inverse = read({.width = 20, .height = 18, .photometric = PHOTOMETRIC_MINISWHITE});
  EXPECT_EQ(*inverse.black, 255.0);
  EXPECT_EQ(*inverse.white, 0.0);
  const TiffPage separate{.width = 2, .channels = 3, .photometric = PHOTOMETRIC_RGB, .planar = PLANARCONFIG_SEPARATE};
  const std::string planes = tiff_of<std::uint8_t>(separate, {{1, 2, 3, 4, 5, 6}});
  EXPECT_EQ(read_picture(planes, {.page = {}, .channel = 3}).samples, (Numbers{5, 6}));
  EXPECT_NE(refusal(tiff_of<std::uint8_t>({.orientation = ORIENTATION_RIGHTTOP}, {{1}})).find("save it upright"),
            std::string::npos);
}

TEST_F(Pictures, ThatCannotBeReadSayWhy) {
  const std::string png = png_of(PNG_COLOR_TYPE_GRAY, 16, {1, 2, 3, 4}, 1);
  const std::string tiff = tiff_of<std::uint16_t>({.width = 4}, {{1, 2, 3, 4}});
  EXPECT_EQ(refusal(png.substr(0, png.size() - 16)), "cannot be read as PNG: the file ends too early");
  EXPECT_EQ(refusal("\x89PNG and then nothing"), "cannot be read as PNG: PNG file corrupted by ASCII conversion");
  EXPECT_NE(refusal(tiff.substr(0, 20)).find("cannot be read as TIFF: "), std::string::npos);
  EXPECT_EQ(refusal("\xff\xd8\xff\xe0 and so on"), "is neither PNG nor TIFF but JPEG, whatever its name says");
  EXPECT_EQ(refusal(""), "is neither PNG nor TIFF, whatever its name says");
  EXPECT_NE(refusal(tiff_of<std::int16_t>({.format = SAMPLEFORMAT_INT}, {{-1}}))
                .find("has samples of 16 bits, signed integers"),
            std::string::npos);
  const TiffPage inks{.channels = 4, .photometric = PHOTOMETRIC_SEPARATED};
  EXPECT_NE(refusal(tiff_of<std::uint8_t>(inks, {{1, 2, 3, 4}})).find("neither as greyscale nor as RGB"),
            std::string::npos);
}

} // namespace
} // namespace matrigrate::fields
