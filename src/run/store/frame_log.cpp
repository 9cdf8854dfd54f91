#include "store/frame_log.hpp"

#include "base/failure.hpp"
#include "store/deflate.hpp"

#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <span>

namespace matrigrate::store {

namespace {

constexpr std::string_view frame_log_magic = "matrigrate frames 1\n";
constexpr std::size_t max_frame_bytes = std::size_t{1} << 30U; // of a frame

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
    if (n > max_frame_bytes) throw InputOutputError("a frame states an impossible number of values");
    const std::string_view planes = some(n * sizeof(T));
    values.resize(n);
    from_byte_planes(planes, std::span(values));
  }

  bool empty() const { return m_bytes.empty(); }

private:
  std::string_view some(std::size_t n) {
    if (n > m_bytes.size()) throw InputOutputError("a frame is shorter than its stated length");
    const std::string_view part = m_bytes.substr(0, n);
    m_bytes.remove_prefix(n);
    return part;
  }
  std::string_view m_bytes;
};

std::string as_block(std::string_view content) {
  const std::string stored = deflated_fast(content);
  std::string bytes;
  put(bytes, BlockHead{stored.size(), content.size(), XXH3_64bits(stored.data(), stored.size())});
  return bytes + stored;
}

/// Whether a block can have this head: deflated bytes are hardly longer than what they were made of, and no byte of
/// them stands for more than 1032.
bool is_plausible(const BlockHead& head) {
  constexpr std::uint64_t most_expanded = 1032;
  return head.size > 0 && head.size <= max_frame_bytes && head.stored > 0
         && head.stored <= head.size + head.size / 64 + 64 && head.size / most_expanded <= head.stored;
}

/// The content of the next block of a stream; none if it is not whole.
std::optional<std::string> next_content(std::istream& log) {
  constexpr std::size_t piece = std::size_t{1} << 20U; // a length that is wrong must not take all memory
  BlockHead head{};
  if (!log.read(reinterpret_cast<char*>(&head), sizeof(head)) || !is_plausible(head)) return std::nullopt;
  std::string stored;
  while (stored.size() < head.stored) {
    const std::size_t before = stored.size();
    stored.resize(std::min<std::uint64_t>(head.stored, before + piece));
    if (!log.read(stored.data() + before, static_cast<std::streamsize>(stored.size() - before))) return std::nullopt;
  }
  if (XXH3_64bits(stored.data(), stored.size()) != head.hash) return std::nullopt;
  return inflated(stored, head.size);
}

/// Where the first whole block of at least `smallest` bytes begins; none: npos.
/// @param budget  bytes that may still be hashed, so that bytes which look like heads everywhere cannot take for ever
std::size_t find_block(std::string_view bytes, std::size_t smallest, std::size_t& budget) {
  for (std::size_t at = 0; at + sizeof(BlockHead) <= bytes.size(); ++at) {
    BlockHead head{};
    std::memcpy(&head, bytes.data() + at, sizeof(head));
    const std::string_view rest = bytes.substr(at + sizeof(head));
    if (!is_plausible(head) || head.size < smallest || head.stored > rest.size()) continue;
    if (head.stored > budget) return std::string_view::npos;
    budget -= head.stored;
    if (XXH3_64bits(rest.data(), head.stored) == head.hash) return at;
  }
  return std::string_view::npos;
}

observe::Frame frame_of(const std::string& content) {
  Taker taker(content);
  observe::Frame frame{.t = taker.take<double>(), .matrix = {}, .outline = {}, .protrusions = {}};
  for (const auto& field : observe::float_fields())
    if (field.of_all) taker.take_planes(field.of(frame));
  for (const auto& field : observe::byte_fields()) taker.take_planes(field.of(frame));
  for (observe::Floats* more : {&frame.outline.cell, &frame.protrusions.cell, &frame.matrix.attractant, &frame.nucleus})
    if (!taker.empty()) taker.take_planes(*more);
  return frame;
}

/// Whether whole numbers up to this one are exact in 32 bits.
bool is_whole(float number) { return number >= 0.0F && number <= 16777216.0F && number == std::floor(number); }

} // namespace

bool fits(const observe::Frame& frame, const observe::FrameHead& head, std::size_t fibres) {
  const std::size_t outline = frame.outline.f_mat.size();
  const std::size_t alive = frame.protrusions.id.size();
  const bool several = !frame.outline.cell.empty();
  const auto right = [&](const auto& field) {
    const auto& numbers = field.in(frame);
    const bool none = field.name == "matrix/attractant" ? numbers.empty() : field.of_several_cells() && !several;
    const std::size_t entries = none                                     ? 0
                                : field.name == "nucleus/position"       ? numbers.size() / 2
                                : field.name == "matrix/fibre_von_mises" ? fibres
                                : field.name.starts_with("matrix/")      ? head.particles()
                                : field.of_protrusions()                 ? alive
                                                                         : outline;
    return numbers.size() == entries * field.components && (!field.whole || std::ranges::all_of(numbers, is_whole));
  };
  const std::size_t cells = observe::outline_ends(frame.outline).size();
  const bool nuclei = frame.nucleus.empty() || (cells > 0 && frame.nucleus.size() % (2 * cells) == 0);
  return std::isfinite(frame.t) && nuclei && std::ranges::all_of(observe::float_fields(), right)
         && std::ranges::all_of(observe::byte_fields(), right);
}

std::string log_head(const observe::FrameHead& head) {
  std::string content;
  put(content, head.radius);
  put(content, head.spacing);
  put_planes(content, head.reference);
  const auto is_empty = [](const observe::Floats& layer) { return layer.empty(); };
  if (head.obstacle.empty() && std::ranges::all_of(head.layers, is_empty))
    return std::string(frame_log_magic) + as_block(content);
  put_planes(content, head.obstacle);
  for (const observe::Floats& layer : head.layers) put_planes(content, layer);
  return std::string(frame_log_magic) + as_block(content);
}

std::string log_frame(const observe::Frame& frame) {
  std::string content;
  put(content, frame.t);
  for (const auto& field : observe::float_fields())
    if (field.of_all) put_planes(content, field.in(frame));
  for (const auto& field : observe::byte_fields()) put_planes(content, field.in(frame));
  const bool attractant = !frame.matrix.attractant.empty();
  const bool nuclei = !frame.nucleus.empty();
  if (attractant || nuclei || !frame.outline.cell.empty()) {
    put_planes(content, frame.outline.cell);
    put_planes(content, frame.protrusions.cell);
  }
  if (attractant || nuclei) put_planes(content, frame.matrix.attractant);
  if (nuclei) put_planes(content, frame.nucleus);
  return as_block(content);
}

observe::Film read_log(std::istream& log, const std::function<void(observe::Frame&)>& each) {
  FrameReader reader(log);
  observe::Film film{.head = reader.head(), .frames = {}};
  while (std::optional<observe::Frame> frame = reader.next()) {
    if (each) each(*frame);
    film.frames.push_back(*std::move(frame));
  }
  return film;
}

FrameReader::FrameReader(std::istream& log) : m_log(&log) {
  std::string start(frame_log_magic.size(), '\0');
  if (!log.read(start.data(), static_cast<std::streamsize>(start.size())) || start != frame_log_magic)
    throw InputOutputError("is no log of frames");
  const std::optional<std::string> content = next_content(log);
  if (!content) throw InputOutputError("is cut short or has been changed");
  Taker head(*content);
  m_head.radius = head.take<double>();
  m_head.spacing = head.take<double>();
  head.take_planes(m_head.reference);
  if (head.empty()) return; // the same matrix everywhere
  head.take_planes(m_head.obstacle);
  for (observe::Floats& layer : m_head.layers) head.take_planes(layer);
  if (!m_head.consistent()) throw InputOutputError("its arrays do not match");
}

std::optional<observe::Frame> FrameReader::next() {
  while (true) {
    const std::streampos start = m_log->tellg();
    if (start < 0) return std::nullopt;
    try {
      if (const std::optional<std::string> content = next_content(*m_log)) {
        observe::Frame frame = frame_of(*content);
        if (!m_fibres) m_fibres = frame.matrix.fibre_von_mises.empty() ? 0 : m_head.particles();
        if (fits(frame, m_head, *m_fibres)) return frame;
        continue; // whole, but of other bodies
      }
    } catch (const InputOutputError&) { // whole, but no frame
      continue;
    }
    if (!find_next(start)) return std::nullopt;
  }
}

/// Goes to the next whole block behind the place where one was expected.
bool FrameReader::find_next(std::streampos start) {
  m_log->clear();
  m_log->seekg(start);
  if (m_log != &m_rest) { // from here on in memory, so that much damage does not take many readings of the file
    m_rest.str(std::string(std::istreambuf_iterator<char>(*m_log), {}));
    m_log = &m_rest;
    m_budget = 8 * m_rest.view().size();
    start = 0;
  }
  const std::string_view rest = m_rest.view().substr(static_cast<std::size_t>(start));
  if (rest.empty()) return false;
  const std::size_t at = find_block(rest.substr(1), sizeof(double) * m_head.particles(), m_budget);
  if (at == std::string_view::npos) return false;
  m_rest.seekg(start + static_cast<std::streamoff>(1 + at));
  return true;
}

void FrameLog::add(const observe::Frame& frame) { m_file.append(log_frame(frame)); }

} // namespace matrigrate::store
