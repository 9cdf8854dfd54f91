#include "fields/picture.hpp"

#include <fmt/format.h>
#include <png.h>

#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <stdexcept>

namespace matrigrate::fields {

namespace {

/// libpng reports a fault by a jump. So what calls it has no local variables, and nothing to destroy.
class PngReader {
public:
  explicit PngReader(std::string_view bytes)
      : m_bytes(bytes), m_png(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &fail, &ignore)) {
    if (m_png != nullptr) m_info = png_create_info_struct(m_png);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&m_png, &m_info, nullptr); }

  /// Reads the header, and sees to it that samples come as they are stored, grey or red, green and blue, of 8 or 16
  /// bits.
  bool begin() {
    if (m_info == nullptr || setjmp(png_jmpbuf(m_png)) != 0) return false;
    png_set_read_fn(m_png, this, &give);
    png_set_keep_unknown_chunks(m_png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1); // texts, profiles, gamma
    png_set_keep_unknown_chunks(m_png, PNG_HANDLE_CHUNK_ALWAYS, animation.data(), 1);
    png_read_info(m_png, m_info);
    png_set_expand(m_png);
    if (png_get_bit_depth(m_png, m_info) == 16 && std::endian::native == std::endian::little) png_set_swap(m_png);
    png_set_interlace_handling(m_png);
    png_read_update_info(m_png, m_info);
    return true;
  }

  bool read(png_bytepp rows) {
    if (setjmp(png_jmpbuf(m_png)) != 0) return false;
    png_read_image(m_png, rows);
    png_read_end(m_png, nullptr);
    return true;
  }

  /// After begin(), without data.
  Raster description() const {
    const bool wide = png_get_bit_depth(m_png, m_info) == 16;
    const int colour_type = png_get_color_type(m_png, m_info);
    return {.width = png_get_image_width(m_png, m_info),
            .height = png_get_image_height(m_png, m_info),
            .channels = png_get_channels(m_png, m_info),
            .colour = (colour_type & PNG_COLOR_MASK_COLOR) != 0,
            .alpha = (colour_type & PNG_COLOR_MASK_ALPHA) != 0,
            .type = wide ? SampleType::whole_16 : SampleType::whole_8,
            .full = wide ? 65535.0 : 255.0,
            .zero_is_white = false,
            .data = {}};
  }

  bool animated() const {
    png_unknown_chunkp chunks = nullptr;
    return png_get_unknown_chunks(m_png, m_info, &chunks) > 0; // begin() keeps no others
  }

  const char* message() const { return m_message.data(); }

private:
  static constexpr std::array<png_byte, 5> animation{'a', 'c', 'T', 'L', 0};

  [[noreturn]] static void fail(png_structp png, png_const_charp message) {
    auto& reader = *static_cast<PngReader*>(png_get_error_ptr(png));
    std::strncpy(reader.m_message.data(), message, reader.m_message.size() - 1);
    png_longjmp(png, 1);
  }

  static void ignore(png_structp /*png*/, png_const_charp /*warning*/) {}

  static void give(png_structp png, png_bytep to, std::size_t size) {
    auto& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
    if (size > reader.m_bytes.size()) png_error(png, "the file ends too early");
    std::memcpy(to, reader.m_bytes.data(), size);
    reader.m_bytes.remove_prefix(size);
  }

  std::string_view m_bytes; ///< that have not been read
  std::array<char, 120> m_message{};
  png_structp m_png = nullptr;
  png_infop m_info = nullptr;
};

[[noreturn]] void refuse(const PngReader& png) {
  throw std::invalid_argument(fmt::format("cannot be read as PNG: {}", png.message()));
}

} // namespace

Raster read_png(std::string_view bytes) {
  PngReader png(bytes);
  if (!png.begin()) refuse(png);
  if (png.animated()) throw std::invalid_argument("is an animation; save one of its pictures");
  Raster raster = png.description();
  raster.allocate();
  const std::size_t bytes_of_row = raster.data.size() / raster.height;
  std::vector<png_bytep> rows(raster.height);
  for (std::size_t row = 0; row < raster.height; ++row)
    rows[row] = reinterpret_cast<png_bytep>(raster.data.data() + row * bytes_of_row);
  if (!png.read(rows.data())) refuse(png);
  return raster;
}

} // namespace matrigrate::fields
