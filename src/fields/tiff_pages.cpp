#include "fields/tiff_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

namespace matrigrate::fields::tiff {

namespace {

Source& of(thandle_t handle) { return *static_cast<Source*>(handle); }

tmsize_t read(thandle_t handle, void* to, tmsize_t size) {
  Source& source = of(handle);
  if (source.at >= source.bytes.size() || size <= 0) return 0;
  const std::size_t got = std::min(static_cast<std::size_t>(size), source.bytes.size() - source.at);
  std::memcpy(to, source.bytes.data() + source.at, got);
  source.at += got;
  return static_cast<tmsize_t>(got);
}
tmsize_t write(thandle_t /*handle*/, void* /*from*/, tmsize_t /*size*/) { return 0; }
toff_t seek(thandle_t handle, toff_t offset, int whence) {
  Source& source = of(handle);
  if (whence == SEEK_CUR) offset += source.at;
  if (whence == SEEK_END) offset += source.bytes.size();
  return source.at = offset;
}
int close(thandle_t /*handle*/) { return 0; }
toff_t size(thandle_t handle) { return of(handle).bytes.size(); }

int fail(TIFF* /*tiff*/, void* user_data, const char* /*module*/, const char* format, va_list values) {
  auto& message = static_cast<Source*>(user_data)->message;
  if (message[0] == '\0') std::vsnprintf(message.data(), message.size(), format, values);
  return 1;
}
int ignore(TIFF* /*tiff*/, void* /*user_data*/, const char* /*module*/, const char* /*format*/, va_list /*values*/) {
  return 1;
}

/// Tags of a directory that tell how large its pixels are.
struct Tags {
  std::uint32_t width = 0, height = 0;
  double x_resolution = 0.0, y_resolution = 0.0;
  std::uint16_t unit = RESUNIT_INCH;
  bool reduced = false; ///< a smaller version of another page

  bool operator==(const Tags&) const = default;

  static Tags of(TIFF* tiff) {
    return {.width = value_of<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0),
            .height = value_of<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0),
            .x_resolution = double{value_of<float>(tiff, TIFFTAG_XRESOLUTION, 0.0F)},
            .y_resolution = double{value_of<float>(tiff, TIFFTAG_YRESOLUTION, 0.0F)},
            .unit = value_of<std::uint16_t>(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH),
            .reduced = (value_of<std::uint32_t>(tiff, TIFFTAG_SUBFILETYPE, 0) & FILETYPE_REDUCEDIMAGE) != 0};
  }
};

std::string description_of(TIFF* tiff) {
  const char* text = nullptr;
  return TIFFGetField(tiff, TIFFTAG_IMAGEDESCRIPTION, &text) != 0 && text != nullptr ? text : "";
}

/// How many planes ImageJ counts in its description; 1 if it says nothing.
std::size_t planes_of(std::string_view description) {
  constexpr std::string_view key = "\nimages=";
  const std::size_t at = description.find(key);
  std::size_t planes = 1;
  if (description.starts_with("ImageJ=") && at != std::string_view::npos)
    std::from_chars(description.data() + at + key.size(), description.data() + description.size(), planes);
  return std::max<std::size_t>(planes, 1);
}

/// How large the pixels of a page are. Only ImageJ and OME describe all pages in the first one.
std::optional<PixelSize> pixel_of(const std::string& description, const Tags& first, const Tags& own, std::size_t ifd) {
  const bool same_size = own.width == first.width && own.height == first.height;
  const bool no_tags = own.x_resolution == 0.0 && own.y_resolution == 0.0;
  const bool of_first = description.starts_with("ImageJ=") && same_size && no_tags;
  // Some programs copy the resolution of a picture to smaller versions of it.
  const bool copied = own.reduced && !same_size && own.x_resolution == first.x_resolution;
  const Tags& tags = of_first ? first : own;
  StatedScale scale{.description = description, .directory = ifd, .columns = own.width, .rows = own.height};
  if (!copied) scale.x_resolution = tags.x_resolution, scale.y_resolution = tags.y_resolution;
  if (tags.unit == RESUNIT_INCH) scale.unit = StatedScale::Unit::inch;
  if (tags.unit == RESUNIT_CENTIMETER) scale.unit = StatedScale::Unit::centimetre;
  return pixel_size(scale);
}

} // namespace

Tiff open(Source& source) {
  const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                             TIFFOpenOptionsFree);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), static_cast<tmsize_t>(max_block_bytes));
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), &fail, &source);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), &ignore, nullptr);
  return {
      TIFFClientOpenExt("picture", "rm", &source, &read, &write, &seek, &close, &size, nullptr, nullptr, options.get()),
      TIFFClose};
}

void refuse(const Source& source) {
  throw std::invalid_argument(
      fmt::format("cannot be read as TIFF{}{}", source.message[0] == '\0' ? "" : ": ", source.message.data()));
}

Page choose_page(TIFF* tiff, const Source& source, const std::optional<std::size_t>& number) {
  const std::string description = description_of(tiff);
  const Tags first = Tags::of(tiff);
  const std::size_t directories = TIFFNumberOfDirectories(tiff);
  const std::size_t pages = directories == 1 ? planes_of(description) : directories;
  if (!number && pages > 1)
    throw std::invalid_argument(fmt::format("has {0} pages: choose one with page=1 to page={0}", pages));
  const std::size_t page = number.value_or(1) - 1;
  if (page >= pages) throw std::invalid_argument(fmt::format("has no page {}: it has {}", page + 1, pages));
  const std::size_t ifd = directories == 1 ? 0 : page;
  if (TIFFSetDirectory(tiff, static_cast<tdir_t>(ifd)) == 0) refuse(source);
  return {.plane = page - ifd, .pixel = pixel_of(description, first, Tags::of(tiff), ifd)};
}

} // namespace matrigrate::fields::tiff
