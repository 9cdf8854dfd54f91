#pragma once

#include "state/state.hpp"

#include <memory>
#include <string>
#include <string_view>

struct XXH3_state_s; // of xxHash

/// Fingerprints: equal ones mean equal bits. XXH3 with 64 bits, of the library xxHash; its values are the same on all
/// machines with little-endian numbers. Test: tests/unit/io/trajectory_hash_test.cpp
namespace matrigrate::io {

/// Fingerprint of all positions of cell and matrix at a sequence of times.
class TrajectoryHash {
public:
  TrajectoryHash();

  /// Goes on with step and positions of a state.
  void add(const State& s);

  /// Of all that was added so far: 16 hexadecimal digits.
  std::string text() const;

private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> m_state;
};

/// Fingerprint of a text: 16 hexadecimal digits.
std::string text_hash(std::string_view text);

} // namespace matrigrate::io
