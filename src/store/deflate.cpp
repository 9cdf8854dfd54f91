#include "store/deflate.hpp"

#include "base/failure.hpp"

#include <zlib.h>

#include <new>

namespace matrigrate::store {

std::string deflated(std::string_view bytes, int level) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
                level)
      != Z_OK)
    throw std::bad_alloc();
  out.resize(size);
  return out;
}

std::string deflated_fast(std::string_view bytes) {
  if (bytes.size() > max_bytes_fast) throw InputOutputError("there is too much to compress at once");
  constexpr int level = 1, window_bits = 15, memory_level = 8; // the latter zlib's own choices
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, window_bits, memory_level, Z_RLE) != Z_OK) throw std::bad_alloc();
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())); // zlib only reads them
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int status = deflate(&stream, Z_FINISH); // in one go: there is room for all
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::bad_alloc();
  return out;
}

std::string inflated(std::string_view bytes, std::size_t size) {
  std::string out(size, '\0');
  uLongf got = size;
  const int status = uncompress(reinterpret_cast<Bytef*>(out.data()), &got,
                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  if (status != Z_OK || got != size) throw InputOutputError("compressed bytes cannot be read");
  return out;
}

} // namespace matrigrate::store
