#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace matrigrate::store {

// Bytes compressed by zlib, as one stream (RFC 1950). Test: tests/unit/store/store_test.cpp

inline constexpr std::size_t max_bytes_fast = std::size_t{1} << 30U; ///< a frame, and then some

/// @param level  1 fast to 9 small
std::string deflated(std::string_view bytes, int level);

/// deflated() that searches only for repeats of one byte: half the time, a tenth more bytes for byte_planes().
/// @throws InputOutputError if there are more than max_bytes_fast
std::string deflated_fast(std::string_view bytes);

/// The bytes that deflated() or deflated_fast() was given.
/// @param size  number of these bytes
/// @throws InputOutputError if the bytes are no such stream, or give another size
std::string inflated(std::string_view bytes, std::size_t size);

/// The first bytes of all numbers, then their second ones, and so on: neighbouring numbers are alike in some of them,
/// which compresses better.
template <class Number>
std::string byte_planes(std::span<const Number> values) {
  std::string planes(values.size_bytes(), '\0');
  const auto* bytes = reinterpret_cast<const char*>(values.data());
  for (std::size_t plane = 0; plane < sizeof(Number); ++plane)
    for (std::size_t i = 0; i < values.size(); ++i)
      planes[plane * values.size() + i] = bytes[i * sizeof(Number) + plane];
  return planes;
}

/// The numbers of which these are the byte_planes().
template <class Number>
void from_byte_planes(std::string_view planes, std::span<Number> values) {
  auto* bytes = reinterpret_cast<char*>(values.data());
  for (std::size_t plane = 0; plane < sizeof(Number); ++plane)
    for (std::size_t i = 0; i < values.size(); ++i)
      bytes[i * sizeof(Number) + plane] = planes[plane * values.size() + i];
}

// Bytes as text. Test: tests/unit/store/store_test.cpp

/// base64 with padding (RFC 4648).
std::string base64(std::string_view bytes);

} // namespace matrigrate::store
