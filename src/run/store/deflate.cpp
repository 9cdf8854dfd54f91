#include "store/deflate.hpp"

#include "base/failure.hpp"

#include <zlib.h>

#include <array>
#include <cstdint>
#include <new>

namespace matrigrate::store {

namespace {

/// Grows with what comes out, so that it never takes as much memory as the bytes.
std::string compressed(std::string_view bytes, int level, int strategy) {
  constexpr std::size_t max_part = std::size_t{1} << 30U; // what zlib can be given at once
  constexpr int window_bits = 15, memory_level = 8;       // zlib's own choices
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, window_bits, memory_level, strategy) != Z_OK) throw std::bad_alloc();
  std::array<char, 1U << 15U> piece{};
  std::string out;
  int status = Z_OK;
  while (status == Z_OK) {
    if (stream.avail_in == 0) {
      const std::string_view part = bytes.substr(0, max_part);
      bytes.remove_prefix(part.size());
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data())); // zlib only reads them
      stream.avail_in = static_cast<uInt>(part.size());
    }
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    status = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
    out.append(piece.data(), piece.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::bad_alloc();
  return out;
}

} // namespace

std::string deflated(std::string_view bytes, int level) { return compressed(bytes, level, Z_DEFAULT_STRATEGY); }

std::string deflated_fast(std::string_view bytes) {
  if (bytes.size() > max_bytes_fast) throw InputOutputError("there is too much to compress at once");
  return compressed(bytes, 1, Z_RLE);
}

std::string inflated(std::string_view bytes, std::size_t size) {
  std::string out(size, '\0');
  uLongf got = size;
  const int status = uncompress(reinterpret_cast<Bytef*>(out.data()), &got,
                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  if (status != Z_OK || got != size) throw InputOutputError("compressed bytes cannot be read");
  return out;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) -> std::uint32_t {
      return i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U;
    };
    const std::uint32_t three = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? alphabet[three >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

} // namespace matrigrate::store
