#pragma once

#include "state/ecm.hpp"

#include <cstdint>

namespace matrigrate {

/// The whole simulation at one time: all that is needed to go on.
struct State {
  std::uint64_t step = 0; ///< steps done
  double t = 0.0;         ///< [s]
  EcmState ecm;
};

} // namespace matrigrate
