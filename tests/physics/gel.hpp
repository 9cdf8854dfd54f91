#pragma once

#include "parameters/parameters.hpp"
#include "state/image.hpp"
#include "state/initial.hpp"
#include "state/state.hpp"

namespace matrigrate {

/// A disc of 60 um without a cell.
inline Parameters small() {
  Parameters p;
  p.ecm.radius = 60.0;
  return p;
}

inline State start(const Parameters& p) {
  State s;
  s.ecm = disc(p);
  return s;
}

/// Whether two states are the same to the last bit, in all that is needed to go on.
inline bool same_bits(const State& a, const State& b) { return image_of(a) == image_of(b); }

} // namespace matrigrate
