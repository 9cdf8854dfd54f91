#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

/// SIMD vectors of a fixed width (the vector extensions of GCC and clang) with load, store and fill. Explicit packs
/// keep the compiler from vectorising the wrong loop. Functions that use them are marked MATRIGRATE_SIMD. Test:
/// tests/unit/base/base_test.cpp
namespace matrigrate {

inline constexpr std::size_t pack_bytes = 32; // a register of AVX2, two of SSE2 or NEON

using Doubles = double __attribute__((vector_size(pack_bytes))); ///< four of them
using Floats = float __attribute__((vector_size(pack_bytes)));   ///< eight of them
using HalfFloats = float __attribute__((vector_size(pack_bytes / 2)));
using TwoFloats = float __attribute__((vector_size(2 * sizeof(float))));

template <class Pack>
inline constexpr std::size_t pack_size = sizeof(Pack) / sizeof(Pack{}[0]);

/// Reads the pack that begins at p (no alignment needed).
template <class Pack, class Number>
[[gnu::always_inline]] inline void load(const Number* p, Pack& a) {
  static_assert(sizeof(a[0]) == sizeof(Number));
  std::memcpy(&a, p, sizeof a);
}

template <class Pack, class Number>
[[gnu::always_inline]] inline void store_pack(const Pack& a, Number* p) {
  static_assert(sizeof(a[0]) == sizeof(Number));
  std::memcpy(p, &a, sizeof a);
}

/// Sets all numbers of a. By way of memory: GCC 12 makes one instruction of it, also in a function that is inlined
/// where newer ones are allowed; set one by one, or all at once, the numbers take three to five.
template <class Pack, class Number>
[[gnu::always_inline]] inline void fill(Number value, Pack& a) {
  Number all[pack_size<Pack>];
  for (Number& number : all) number = value;
  load(all, a);
}

/// Four floats as doubles, by one instruction of AVX; GCC 12 makes four of __builtin_convertvector.
[[gnu::always_inline]] inline void widen(const HalfFloats& a, Doubles& b) { b = Doubles{a[0], a[1], a[2], a[3]}; }

/// Whether any number of a has a bit set (is not +0).
template <class Pack>
[[gnu::always_inline]] inline bool any(const Pack& a) {
  std::uint64_t bits[sizeof a / sizeof(std::uint64_t)];
  std::memcpy(bits, &a, sizeof a);
  std::uint64_t all = 0;
  for (const std::uint64_t b : bits) all |= b;
  return all != 0;
}

} // namespace matrigrate
