#include "io/frame_log.hpp"

#include "base/failure.hpp"
#include "io/deflate.hpp"

#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <sstream>
#include <utility>

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

template <class T>
void put_planes(std::string& to, const std::vector<T>& values) {
  put(to, std::uint64_t{values.size()});
  to += byte_planes(std::span<const T>(values));
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
  const std::string stored = deflated_fast(content);
  std::string bytes;
  put(bytes, BlockHead{stored.size(), content.size(), XXH3_64bits(stored.data(), stored.size())});
  return bytes + stored;
}

/// A whole block at the front of bytes.
struct Block {
  BlockHead head;
  std::string_view stored;
  std::size_t bytes() const { return sizeof(BlockHead) + stored.size(); }
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

/// The content of the next block of a stream; none if it is not whole.
std::optional<std::string> next_content(std::istream& log) {
  constexpr std::size_t piece = std::size_t{1} << 20U; // a length that is wrong must not take all memory
  BlockHead head{};
  if (!log.read(reinterpret_cast<char*>(&head), sizeof(head)) || head.size > most_bytes) return std::nullopt;
  std::string stored;
  while (stored.size() < head.stored) {
    const std::size_t before = stored.size();
    stored.resize(std::min<std::uint64_t>(head.stored, before + piece));
    if (!log.read(stored.data() + before, static_cast<std::streamsize>(stored.size() - before))) return std::nullopt;
  }
  if (XXH3_64bits(stored.data(), stored.size()) != head.hash) return std::nullopt;
  return inflated(stored, head.size);
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
  std::istringstream log{std::string(bytes)};
  return read_log(log);
}

Film read_log(std::istream& log, const std::function<void(Frame&)>& each) {
  FrameReader reader(log);
  Film film{.head = reader.head(), .frames = {}};
  while (std::optional<Frame> frame = reader.next()) {
    if (each) each(*frame);
    film.frames.push_back(*std::move(frame));
  }
  return film;
}

FrameReader::FrameReader(std::istream& log) : m_log(log) {
  std::string start(magic.size(), '\0');
  if (!log.read(start.data(), static_cast<std::streamsize>(start.size())) || start != magic)
    throw InputOutputError("is no log of frames");
  const std::optional<std::string> content = next_content(log);
  if (!content) throw InputOutputError("is cut short or has been changed");
  Taker head(*content);
  m_head.radius = head.take<double>();
  m_head.spacing = head.take<double>();
  head.take_planes(m_head.reference);
}

std::optional<Frame> FrameReader::next() {
  const std::optional<std::string> content = next_content(m_log);
  if (!content) return std::nullopt;
  return frame_of(*content);
}

void FrameLog::add(const Frame& frame) { m_file.append(frame_bytes(frame)); }

} // namespace matrigrate::io
