#pragma once

#include "state/state.hpp"

#include <cstdint>
#include <string>
#include <string_view>

/// Fingerprints: equal ones mean equal bits. XXH3 with 64 bits, of the library xxHash; its values are the same on all
/// machines with little-endian numbers. Test: tests/unit/store/store_test.cpp
namespace matrigrate::store {

/// Fingerprint of all positions of cells and matrix at a sequence of times. Each one is the seed of the next, so that
/// a sequence can go on from its fingerprint.
class TrajectoryHash {
public:
  explicit TrajectoryHash(std::uint64_t so_far = 0) : m_hash(so_far) {}

  /// Goes on with step and positions of a state.
  void add(const State& s);

  /// Fingerprint of all that was added so far.
  std::uint64_t value() const { return m_hash; }
  std::string text() const; ///< value() as 16 hexadecimal digits

private:
  std::uint64_t m_hash;
};

/// Fingerprint of a text: 16 hexadecimal digits.
std::string text_hash(std::string_view text);

} // namespace matrigrate::store
