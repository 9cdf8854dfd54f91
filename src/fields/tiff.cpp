#include "fields/picture.hpp"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>

namespace matrigrate::fields {

namespace {

constexpr std::size_t max_block_bytes = std::size_t{1} << 28U; // of a strip or tile, and of all that libtiff takes

/// A TIFF in memory, as libtiff asks for it.
struct Source {
  std::string_view bytes;
  std::uint64_t at = 0;
  std::array<char, 200> message{}; ///< the first fault
};

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

/// @return  null if it is no TIFF
std::unique_ptr<TIFF, void (*)(TIFF*)> open(Source& source) {
  const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                             TIFFOpenOptionsFree);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), static_cast<tmsize_t>(max_block_bytes));
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), &fail, &source);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), &ignore, nullptr);
  return {
      TIFFClientOpenExt("picture", "rm", &source, &read, &write, &seek, &close, &size, nullptr, nullptr, options.get()),
      TIFFClose};
}

/// @throws std::invalid_argument always: it cannot be read, with libtiff's first fault
[[noreturn]] void refuse(const Source& source) {
  throw std::invalid_argument(
      fmt::format("cannot be read as TIFF{}{}", source.message[0] == '\0' ? "" : ": ", source.message.data()));
}

/// A tag of the directory at hand.
template <class Value>
Value value_of(TIFF* tiff, std::uint32_t tag, Value otherwise) {
  Value value = otherwise;
  return TIFFGetFieldDefaulted(tiff, tag, &value) == 0 ? otherwise : value;
}

/// Tags of a directory that tell how large its pixels are.
struct Tags {
  std::uint32_t width = 0, height = 0;
  double x_resolution = 0.0, y_resolution = 0.0;
  std::uint16_t unit = RESUNIT_INCH;
  bool reduced = false; ///< a smaller version of another page

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
  scale.in_centimetres = tags.unit == RESUNIT_CENTIMETER;
  return pixel_size(scale);
}

/// What was chosen of a file.
struct Page {
  std::size_t plane = 0;          ///< of a stack in one directory, from 0; else 0
  std::optional<PixelSize> pixel; ///< as the file states it for this page
};

/// Makes the directory of a page that at hand. The pages of a file with one directory are those that ImageJ's
/// description counts ("images=3").
/// @param number  from 1; may be left out if there is one only
/// @throws std::invalid_argument if there is no such page, or one has to be chosen
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

/// What the samples of a page are.
struct Layout {
  std::size_t bits = 1;
  bool separate = false; ///< each channel is stored on its own
  bool palette = false;
  std::uint16_t orientation = ORIENTATION_TOPLEFT;
};

/// @throws std::invalid_argument if samples are compressed in a way that may change them
void require_lossless(TIFF* tiff) {
  const auto name = [&]() -> const char* {
    switch (value_of<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE)) {
    case COMPRESSION_OJPEG:
    case COMPRESSION_JPEG:
    case 34892: // of DNG
      return "JPEG";
    case COMPRESSION_JP2000:
    case 33003: // of Aperio
    case 33005:
      return "JPEG 2000";
    case COMPRESSION_LERC:
      return "LERC";
    case COMPRESSION_WEBP:
      return "WebP";
    case COMPRESSION_JXL:
      return "JPEG XL";
    default:
      return nullptr;
    }
  }();
  if (name != nullptr)
    throw std::invalid_argument(fmt::format("is compressed as {}, which changes the numbers, so there is no way to "
                                            "read it; save the original without compression, or with deflate or LZW",
                                            name));
}

SampleType type_of(std::size_t bits, std::uint16_t format) {
  if (format == SAMPLEFORMAT_IEEEFP && bits == 32) return SampleType::real_32;
  if (format == SAMPLEFORMAT_IEEEFP && bits == 64) return SampleType::real_64;
  if (format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID) {
    if (bits == 1 || bits == 2 || bits == 4 || bits == 8) return SampleType::whole_8;
    if (bits == 16) return SampleType::whole_16;
    if (bits == 32) return SampleType::whole_32;
  }
  const char* kind = format == SAMPLEFORMAT_INT      ? "signed integers"
                     : format == SAMPLEFORMAT_IEEEFP ? "floating point"
                     : format == SAMPLEFORMAT_UINT   ? "unsigned integers"
                                                     : "another kind";
  throw std::invalid_argument(fmt::format("has samples of {} bits, {}; allowed are unsigned integers of 8, 16 or 32 "
                                          "bits and floating point of 32 or 64 bits",
                                          bits, kind));
}

void describe_colours(TIFF* tiff, Raster& raster, Layout& layout) {
  switch (value_of<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK)) {
  case PHOTOMETRIC_MINISBLACK:
    break;
  case PHOTOMETRIC_MINISWHITE:
    raster.zero_is_white = true;
    break;
  case PHOTOMETRIC_RGB:
    raster.colour = true;
    break;
  case PHOTOMETRIC_PALETTE:
    layout.palette = true;
    break;
  default:
    throw std::invalid_argument("stores its colours neither as greyscale nor as RGB; save it as one of these");
  }
  if (raster.colour && raster.channels < 3)
    throw std::invalid_argument(
        fmt::format("cannot be read as TIFF: it is coloured and has {} channels", raster.channels));
  if (layout.palette && (raster.channels != 1 || raster.type != SampleType::whole_8))
    throw std::invalid_argument("cannot be read as TIFF: it has a palette, but not one channel of up to 8 bits");
  std::uint16_t extra = 0;
  std::uint16_t* kinds = nullptr;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_EXTRASAMPLES, &extra, &kinds);
  raster.alpha = extra == 1 && (kinds[0] == EXTRASAMPLE_ASSOCALPHA || kinds[0] == EXTRASAMPLE_UNASSALPHA)
                 && raster.channels == (raster.colour ? 4 : 2);
}

Layout describe(TIFF* tiff, Raster& raster) {
  Layout layout;
  layout.bits = value_of<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  layout.separate = value_of<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) == PLANARCONFIG_SEPARATE;
  layout.orientation = value_of<std::uint16_t>(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  if (layout.orientation > ORIENTATION_BOTLEFT)
    throw std::invalid_argument("is turned by a quarter, as its orientation tag says; save it upright");
  raster.width = value_of<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
  raster.height = value_of<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
  raster.channels = value_of<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  raster.type = type_of(layout.bits, value_of<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT));
  const bool real = raster.type == SampleType::real_32 || raster.type == SampleType::real_64;
  raster.full = real ? 1.0 : static_cast<double>((std::uint64_t{1} << layout.bits) - 1);
  describe_colours(tiff, raster, layout);
  return layout;
}

/// Copies `count` samples, `from_step` and `to_step` apart, from a row of a block, and spreads those of fewer than 8
/// bits to bytes.
void copy_samples(const std::byte* row, std::size_t bits, std::size_t first, std::size_t from_step, std::byte* to,
                  std::size_t to_step, std::size_t count) {
  const std::size_t bytes = bits < 8 ? 1 : bits / 8;
  for (std::size_t k = 0; k < count; ++k, to += to_step * bytes) {
    const std::size_t number = first + k * from_step;
    if (bits >= 8) {
      std::memcpy(to, row + number * bytes, bytes);
    } else {
      const std::size_t shift = 8 - bits - number * bits % 8;
      const auto mask = static_cast<std::byte>((1U << bits) - 1U);
      *to = (row[number * bits / 8] >> shift) & mask;
    }
  }
}

/// The strips or tiles of a page: all are rectangles of one size.
struct Blocks {
  bool tiled = false;
  std::size_t width = 0, height = 0, bytes = 0, bytes_of_row = 0;

  static Blocks of(TIFF* tiff, const Raster& raster) {
    Blocks blocks;
    blocks.tiled = TIFFIsTiled(tiff) != 0;
    blocks.width = blocks.tiled ? value_of<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0) : raster.width;
    blocks.height = blocks.tiled ? value_of<std::uint32_t>(tiff, TIFFTAG_TILELENGTH, 0)
                                 : value_of<std::uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP, 0);
    if (!blocks.tiled) blocks.height = std::min(blocks.height, raster.height);
    blocks.bytes = blocks.tiled ? TIFFTileSize64(tiff) : TIFFStripSize64(tiff);
    blocks.bytes_of_row = blocks.tiled ? TIFFTileRowSize64(tiff) : TIFFScanlineSize64(tiff);
    if (blocks.width == 0 || blocks.height == 0 || blocks.bytes == 0 || blocks.bytes > max_block_bytes
        || blocks.bytes_of_row > blocks.bytes / blocks.height)
      throw std::invalid_argument("cannot be read as TIFF: its strips or tiles have an impossible size");
    return blocks;
  }
};

void read_samples(TIFF* tiff, const Source& source, const Layout& layout, Raster& raster) {
  const Blocks blocks = Blocks::of(tiff, raster);
  const std::size_t planes = layout.separate ? raster.channels : 1;
  const std::size_t together = layout.separate ? 1 : raster.channels; // channels in a block
  if (blocks.bytes_of_row < (blocks.width * together * layout.bits + 7) / 8)
    throw std::invalid_argument("cannot be read as TIFF: its rows are too short");
  raster.allocate();
  std::vector<std::byte> block(blocks.bytes);
  const auto size = static_cast<tmsize_t>(blocks.bytes);
  const std::size_t bytes = bytes_of(raster.type);
  std::uint32_t number = 0; // of the block; they follow one another by planes, rows and columns
  for (std::size_t plane = 0; plane < planes; ++plane)
    for (std::size_t top = 0; top < raster.height; top += blocks.height)
      for (std::size_t left = 0; left < raster.width; left += blocks.width, ++number) {
        const std::size_t rows = std::min(blocks.height, raster.height - top);
        const tmsize_t got = blocks.tiled ? TIFFReadEncodedTile(tiff, number, block.data(), size)
                                          : TIFFReadEncodedStrip(tiff, number, block.data(), size);
        if (got < static_cast<tmsize_t>(rows * blocks.bytes_of_row)) refuse(source);
        const std::size_t columns = std::min(blocks.width, raster.width - left);
        for (std::size_t row = 0; row < rows; ++row)
          for (std::size_t channel = 0; channel < together; ++channel)
            copy_samples(block.data() + row * blocks.bytes_of_row, layout.bits, channel, together,
                         raster.data.data()
                             + (((top + row) * raster.width + left) * raster.channels + plane + channel) * bytes,
                         raster.channels, columns);
      }
}

/// A plane that ImageJ stores behind the one that a directory tells of: as long, uncompressed, without a gap.
void read_plane(TIFF* tiff, std::string_view file, std::size_t plane, const Layout& layout, Raster& raster) {
  raster.allocate();
  const std::uint64_t begin = TIFFGetStrileOffset(tiff, 0), size = raster.data.size();
  std::uint64_t end = begin;
  bool whole = value_of<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE) == COMPRESSION_NONE
               && TIFFIsTiled(tiff) == 0 && layout.bits >= 8 && !layout.separate;
  for (std::uint32_t strip = 0; whole && strip < TIFFNumberOfStrips(tiff); ++strip) {
    whole = TIFFGetStrileOffset(tiff, strip) == end;
    end += TIFFGetStrileByteCount(tiff, strip);
  }
  if (!whole || end - begin != size || begin > file.size() || (file.size() - begin) / size <= plane)
    throw std::invalid_argument(
        "is a stack in one directory, whose planes do not follow one another uncompressed: save it as separate pages");
  std::memcpy(raster.data.data(), file.data() + begin + plane * size, size);
  if (TIFFIsByteSwapped(tiff) == 0) return;
  const auto bytes = static_cast<std::ptrdiff_t>(bytes_of(raster.type));
  for (auto sample = raster.data.begin(); sample != raster.data.end(); sample += bytes)
    std::reverse(sample, sample + bytes);
}

/// The colours that the samples of a page are numbers of.
void apply_palette(TIFF* tiff, std::size_t bits, Raster& raster) {
  std::array<std::uint16_t*, 3> colours{};
  if (TIFFGetField(tiff, TIFFTAG_COLORMAP, &colours[0], &colours[1], &colours[2]) == 0)
    throw std::invalid_argument("cannot be read as TIFF: it has no palette");
  const std::size_t entries = std::size_t{1} << bits;
  // Stored are 16 bits that were made from 8, by one of two rules; some writers leave 8 bits.
  const bool wide = std::ranges::any_of(
      colours, [&](const std::uint16_t* c) { return std::any_of(c, c + entries, [](auto v) { return v > 255; }); });
  const std::vector<std::byte> numbers = std::move(raster.data);
  raster.colour = true;
  raster.channels = 3;
  raster.full = 255.0;
  raster.allocate();
  for (std::size_t k = 0; k < numbers.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c)
      raster.data[3 * k + c] =
          static_cast<std::byte>(colours[c][std::to_integer<std::size_t>(numbers[k])] >> (wide ? 8 : 0));
}

/// So that the first row is the upper one, and the first pixel of a row the left one.
void turn_upright(std::uint16_t orientation, Raster& raster) {
  const std::size_t pixel = raster.channels * bytes_of(raster.type), row = raster.width * pixel;
  const auto swap = [&](std::size_t a, std::size_t b, std::size_t size) {
    std::swap_ranges(raster.data.data() + a, raster.data.data() + a + size, raster.data.data() + b);
  };
  if (orientation == ORIENTATION_BOTLEFT || orientation == ORIENTATION_BOTRIGHT)
    for (std::size_t i = 0; i < raster.height / 2; ++i) swap(i * row, (raster.height - 1 - i) * row, row);
  if (orientation == ORIENTATION_TOPRIGHT || orientation == ORIENTATION_BOTRIGHT)
    for (std::size_t i = 0; i < raster.height; ++i)
      for (std::size_t k = 0; k < raster.width / 2; ++k)
        swap(i * row + k * pixel, i * row + (raster.width - 1 - k) * pixel, pixel);
}

} // namespace

Raster read_tiff(std::string_view bytes, const std::optional<std::size_t>& page) {
  Source source{bytes};
  const auto tiff = open(source);
  if (!tiff) refuse(source);
  Raster raster;
  const Page chosen = choose_page(tiff.get(), source, page);
  raster.pixel = chosen.pixel;
  require_lossless(tiff.get());
  const Layout layout = describe(tiff.get(), raster);
  chosen.plane == 0 ? read_samples(tiff.get(), source, layout, raster)
                    : read_plane(tiff.get(), bytes, chosen.plane, layout, raster);
  if (layout.palette) apply_palette(tiff.get(), layout.bits, raster);
  turn_upright(layout.orientation, raster);
  return raster;
}

} // namespace matrigrate::fields
