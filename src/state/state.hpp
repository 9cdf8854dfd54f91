#pragma once

#include "state/cortex.hpp"
#include "state/ecm.hpp"
#include "state/protrusion.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace matrigrate {

/// What is kept of earlier steps to solve the next one: the physics would be the same without, but not the bits.
struct SolverMemory {
  std::vector<Vec2> v_before; ///< velocities of all nodes a step before ecm.v and cortex.v; empty: unknown [um/s]
  std::vector<Vec2> x_drag; ///< positions at which the drag of the matrix is taken, a little behind x; empty: at x [um]
};

/// The whole simulation at one time: all that is needed to go on. Without cortex particles it is the matrix alone.
struct State {
  std::uint64_t step = 0; ///< steps done
  double t = 0.0;         ///< [s]
  EcmState ecm;
  CortexState cortex;
  SolverMemory solver_memory;
  std::vector<Protrusion> protrusions; ///< those that live, in the order of initiation
  std::vector<ProtrusionRecord> ended; ///< those that have ended, in the order of their end
  std::optional<double> polarization;  ///< angle of d_pol [rad]; none before the first protrusion
  std::uint32_t initiated = 0;         ///< protrusions initiated so far

  bool has_cell() const { return cortex.size() > 0; }
  /// Node of cortex particle i in the drag system: the cell's nodes follow the matrix's.
  std::uint32_t node(std::size_t i) const { return static_cast<std::uint32_t>(ecm.size() + i); }
};

} // namespace matrigrate
