#pragma once

#include "state/cortex.hpp"
#include "state/protrusion.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace matrigrate {

/// A cell at one time: all that is needed to go on.
struct Cell {
  std::uint32_t id = 0; ///< of its own among the cells of a run, below 2^24; chooses its random numbers
  CortexState cortex;
  CortexState nucleus;                 ///< its lamina, a ring like the cortex; empty without a nucleus
  std::vector<Protrusion> protrusions; ///< those that live, in the order of initiation
  std::vector<ProtrusionRecord> ended; ///< those that have ended, in the order of their end
  std::optional<double> polarization;  ///< angle of d_pol [rad]; none before the first protrusion
  std::uint32_t initiated = 0;         ///< protrusions initiated so far
};

} // namespace matrigrate
