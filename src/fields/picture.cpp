#include "base/failure.hpp"
#include "base/file.hpp"
#include "fields/samples.hpp"

#include <fmt/format.h>
#include <png.h>
#include <tiffio.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace matrigrate::fields {

namespace {

constexpr std::size_t max_pixels = 16'000'000;
constexpr std::size_t max_picture_bytes = std::size_t{1} << 28U;

/// Grey values of a picture, row by row, downwards.
struct Grey {
  std::size_t width = 0, height = 0;
  std::vector<double> values;
};

void check_size(std::size_t width, std::size_t height) {
  if (width == 0 || height == 0 || width > max_pixels / height)
    throw std::invalid_argument(
        fmt::format("is a picture of {} x {} pixels; allowed are 1 to 16 million", width, height));
}

Grey read_png(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, void (*)(png_image*)> freed(&image, [](png_image* i) { png_image_free(i); });
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
    throw std::invalid_argument(fmt::format("cannot be read as PNG: {}", image.message));
  check_size(image.width, image.height);
  image.format = PNG_FORMAT_GRAY;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0)
    throw std::invalid_argument(fmt::format("cannot be read as PNG: {}", image.message));
  Grey grey{image.width, image.height, {}};
  for (const png_byte pixel : pixels) grey.values.push_back(pixel / 255.0);
  return grey;
}

Grey read_tiff(const std::filesystem::path& file) {
  TIFFSetErrorHandler(nullptr);
  TIFFSetWarningHandler(nullptr);
  const std::unique_ptr<TIFF, void (*)(TIFF*)> tiff(TIFFOpen(file.c_str(), "r"), TIFFClose);
  if (!tiff) throw std::invalid_argument("cannot be read as TIFF");
  std::uint32_t width = 0, height = 0;
  TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
  check_size(width, height);
  std::vector<std::uint32_t> pixels(std::size_t{width} * height);
  if (TIFFReadRGBAImageOriented(tiff.get(), width, height, pixels.data(), ORIENTATION_TOPLEFT, 1) == 0)
    throw std::invalid_argument("cannot be read as TIFF");
  Grey grey{width, height, {}};
  for (const std::uint32_t p : pixels) // brightness as of BT.709
    grey.values.push_back((0.2126 * TIFFGetR(p) + 0.7152 * TIFFGetG(p) + 0.0722 * TIFFGetB(p)) / 255.0);
  return grey;
}

} // namespace

Samples samples_from_picture(const std::filesystem::path& file, double pixel, const Vec2& centre) {
  const std::string bytes = read_file(file, max_picture_bytes);
  const Grey grey = bytes.starts_with("\x89PNG") ? read_png(bytes) : read_tiff(file);
  Samples samples{
      .origin =
          centre - 0.5 * pixel * Vec2(static_cast<double>(grey.width) - 1.0, static_cast<double>(grey.height) - 1.0),
      .spacing = {pixel, pixel},
      .columns = grey.width,
      .rows = grey.height,
      .values = std::vector<double>(grey.values.size())};
  for (std::size_t row = 0; row < grey.height; ++row)
    std::copy_n(grey.values.begin() + static_cast<std::ptrdiff_t>((grey.height - 1 - row) * grey.width), grey.width,
                samples.values.begin() + static_cast<std::ptrdiff_t>(row * grey.width));
  return samples;
}

} // namespace matrigrate::fields
