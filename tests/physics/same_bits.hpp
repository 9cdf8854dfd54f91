#pragma once

#include "store/checkpoint.hpp"

namespace matrigrate {

/// Whether two states are the same to the last bit, in all that is needed to go on: what a checkpoint would hold.
inline bool same_bits(const State& a, const State& b) {
  const auto image = [](const State& s) { return store::checkpoint_image({s, {}, {}, {}, {}}); };
  return image(a) == image(b);
}

} // namespace matrigrate
