#include "state/image.hpp"

#include "state/members.hpp"

#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

namespace matrigrate {

namespace {

constexpr std::uint64_t version = 0x4d47'4c49'5645'0005; // "MGLIVE" 5

/// Appends one value after the other.
class ImageWriter {
public:
  void operator()(const StateMember&, const auto& value) { put(value); }

  template <class T>
  void put(const T& value) {
    if constexpr (Listed<T>)
      each_member(value, *this);
    else
      append(&value, sizeof value);
  }
  template <class T>
  void put(const std::vector<T>& all) {
    put(std::uint64_t{all.size()});
    if constexpr (Listed<T>)
      for (const T& one : all) put(one);
    else
      append(all.data(), all.size() * sizeof(T));
  }
  void put(const Phase& phase) {
    put(static_cast<std::uint8_t>(phase.index()));
    std::visit([this](const auto& one) { put(one); }, phase);
  }
  void put(const std::optional<double>& value) {
    put(static_cast<std::uint8_t>(value ? 1 : 0));
    put(value.value_or(0.0));
  }
  std::string take() { return std::move(m_bytes); }

private:
  void append(const void* data, std::size_t bytes) { m_bytes.append(static_cast<const char*>(data), bytes); }

  std::string m_bytes;
};

/// Takes the values in the same order.
class ImageReader {
public:
  explicit ImageReader(std::string_view bytes) : m_rest(bytes) {}

  void operator()(const StateMember&, auto& value) { get(value); }

  template <class T>
  void get(T& value) {
    if constexpr (Listed<T>)
      each_member(value, *this);
    else
      copy(&value, sizeof value);
  }
  template <class T>
  void get(std::vector<T>& all) {
    all.resize(count(Listed<T> ? 1 : sizeof(T)));
    if constexpr (Listed<T>)
      for (T& one : all) get(one);
    else
      copy(all.data(), all.size() * sizeof(T));
  }
  void get(Phase& phase) {
    std::uint8_t index = 0;
    get(index);
    switch (index) {
    case 0:
      phase = Growing();
      break;
    case 1:
      phase = Maturing();
      break;
    case 2:
      phase = Contracting();
      break;
    case 3:
      phase = Finishing();
      break;
    default:
      throw std::invalid_argument("the saved state has a protrusion in an unknown phase");
    }
    std::visit([this](auto& one) { get(one); }, phase);
  }
  void get(std::optional<double>& value) {
    std::uint8_t given = 0;
    double number = 0.0;
    get(given);
    get(number);
    value = given != 0 ? std::optional(number) : std::nullopt;
  }
  bool at_end() const { return m_rest.empty(); }

private:
  /// Of entries that have at least so many bytes.
  std::size_t count(std::size_t bytes) {
    std::uint64_t n = 0;
    get(n);
    if (n > m_rest.size() / bytes) cut_off();
    return static_cast<std::size_t>(n);
  }
  void copy(void* to, std::size_t bytes) {
    if (bytes > m_rest.size()) cut_off();
    if (bytes > 0) std::memcpy(to, m_rest.data(), bytes);
    m_rest.remove_prefix(bytes);
  }
  [[noreturn]] static void cut_off() { throw std::invalid_argument("the saved state is cut short"); }

  std::string_view m_rest;
};

} // namespace

std::string image_of(const State& s) {
  ImageWriter writer;
  writer.put(version);
  writer.put(s);
  return writer.take();
}

State state_of(std::string_view image) {
  ImageReader reader(image);
  std::uint64_t found = 0;
  reader.get(found);
  if (found != version) throw std::invalid_argument("the saved state is of another version of the page");
  State s;
  reader.get(s);
  if (!reader.at_end()) throw std::invalid_argument("the saved state is longer than it should be");
  return s;
}

} // namespace matrigrate
