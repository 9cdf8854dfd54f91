#pragma once

#include "parameters/parameters.hpp"
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

} // namespace matrigrate
