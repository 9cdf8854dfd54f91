#pragma once

#include "state/image.hpp"

namespace matrigrate {

/// Whether two states are the same to the last bit, in all that is needed to go on.
inline bool same_bits(const State& a, const State& b) { return image_of(a) == image_of(b); }

} // namespace matrigrate
