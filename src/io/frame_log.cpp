#include "io/frame_log.hpp"

#include "base/failure.hpp"

#include <xxhash.h>
#include <zlib.h>

#include <cstring>
#include <new>
#include <optional>

namespace matrigrate::io {

namespace {

constexpr std::string_view magic = "matrigrate frames 1\n";
constexpr std::size_t most_bytes = std::size_t{1} << 30U; // of a frame

/// Before each block: bytes of it compressed and not, and its fingerprint.
struct BlockHead {
  std::uint64_t stored, size, hash;
};

template <class T>
void put(std::string& to, const T& value) {
  to.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// The bytes of all numbers, first ones first: neighbouring numbers begin alike, which compresses better.
template <class T>
void put_planes(std::string& to, const std::vector<T>& values) {
  put(to, std::uint64_t{values.size()});
  const auto* bytes = reinterpret_cast<const char*>(values.data());
  for (std::size_t plane = 0; plane < sizeof(T); ++plane)
    for (std::size_t i = 0; i < values.size(); ++i) to += bytes[i * sizeof(T) + plane];
}

/// Takes values from the front of bytes.
class Taker {
public:
  explicit Taker(std::string_view bytes) : m_bytes(bytes) {}

  template <class T>
  T take() {
    T value;
    std::memcpy(&value, some(sizeof(T)).data(), sizeof(T));
    return value;
  }
  template <class T>
  void take_planes(std::vector<T>& values) {
    const auto n = take<std::uint64_t>();
    if (n > most_bytes) throw InputOutputError("a frame is not what it says");
    const std::string_view planes = some(n * sizeof(T));
    values.resize(n);
    auto* bytes = reinterpret_cast<char*>(values.data());
    for (std::size_t plane = 0; plane < sizeof(T); ++plane)
      for (std::size_t i = 0; i < n; ++i) bytes[i * sizeof(T) + plane] = planes[plane * n + i];
  }

private:
  std::string_view some(std::size_t n) {
    if (n > m_bytes.size()) throw InputOutputError("a frame is shorter than it says");
    const std::string_view part = m_bytes.substr(0, n);
    m_bytes.remove_prefix(n);
    return part;
  }
  std::string_view m_bytes;
};

std::string block(std::string_view content) {
  const std::string stored = deflated(content, 3);
  std::string bytes;
  put(bytes, BlockHead{stored.size(), content.size(), XXH3_64bits(stored.data(), stored.size())});
  return bytes + stored;
}

/// A whole block at the front of bytes.
struct Block {
  BlockHead head;
  std::string_view stored;
  std::size_t bytes() const { return sizeof(BlockHead) + stored.size(); }
  std::string content() const { return inflated(stored, head.size); }
};

std::optional<Block> next_block(std::string_view bytes) {
  Block found{};
  if (bytes.size() < sizeof(BlockHead)) return std::nullopt;
  std::memcpy(&found.head, bytes.data(), sizeof(BlockHead));
  bytes.remove_prefix(sizeof(BlockHead));
  if (found.head.stored > bytes.size() || found.head.size > most_bytes) return std::nullopt;
  found.stored = bytes.substr(0, found.head.stored);
  if (XXH3_64bits(found.stored.data(), found.stored.size()) != found.head.hash) return std::nullopt;
  return found;
}

std::string head_bytes(const FrameHead& head) {
  std::string content;
  put(content, head.radius);
  put(content, head.spacing);
  put_planes(content, head.reference);
  return std::string(magic) + block(content);
}

std::string frame_bytes(const Frame& frame) {
  std::string content;
  put(content, frame.t);
  for (const auto& field : float_fields()) put_planes(content, field.in(frame));
  for (const auto& field : byte_fields()) put_planes(content, field.in(frame));
  return block(content);
}

Frame frame_of(const std::string& content) {
  Taker taker(content);
  Frame frame{.t = taker.take<double>(), .matrix = {}, .outline = {}, .protrusions = {}};
  for (const auto& field : float_fields()) taker.take_planes(field.of(frame));
  for (const auto& field : byte_fields()) taker.take_planes(field.of(frame));
  return frame;
}

} // namespace

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

std::string inflated(std::string_view bytes, std::size_t size) {
  std::string out(size, '\0');
  uLongf got = size;
  const int status = uncompress(reinterpret_cast<Bytef*>(out.data()), &got,
                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  if (status != Z_OK || got != size) throw InputOutputError("compressed bytes cannot be read");
  return out;
}

std::string log_bytes(const Film& film) {
  std::string bytes = head_bytes(film.head);
  for (const Frame& frame : film.frames) bytes += frame_bytes(frame);
  return bytes;
}

std::string whole_log(std::string_view bytes, std::size_t frames) {
  if (!bytes.starts_with(magic)) return {};
  std::size_t end = magic.size();
  for (std::size_t k = 0; k <= frames; ++k) { // the head is a block as well
    const std::optional<Block> block = next_block(bytes.substr(end));
    if (!block && k == 0) return {};
    if (!block) break;
    end += block->bytes();
  }
  return std::string(bytes.substr(0, end));
}

Film read_log(std::string_view bytes) {
  if (!bytes.starts_with(magic)) throw InputOutputError("is no log of frames");
  bytes.remove_prefix(magic.size());
  std::optional<Block> block = next_block(bytes);
  if (!block) throw InputOutputError("is cut short or has been changed");
  Film film;
  const std::string content = block->content();
  Taker head(content);
  film.head.radius = head.take<double>();
  film.head.spacing = head.take<double>();
  head.take_planes(film.head.reference);
  for (;;) {
    bytes.remove_prefix(block->bytes());
    if (!(block = next_block(bytes))) return film;
    film.frames.push_back(frame_of(block->content()));
  }
}

void FrameLog::add(const Frame& frame) { m_file.append(frame_bytes(frame)); }

} // namespace matrigrate::io
