#pragma once

#include "state/cell.hpp"
#include "state/ecm.hpp"

#include <cstdint>
#include <vector>

namespace matrigrate {

/// What is kept of earlier steps to solve the next one: the physics would be the same without, but not the bits.
struct SolverMemory {
  std::vector<Vec2> v_before; ///< velocities of all nodes a step before ecm.v and cortex.v; empty: unknown [um/s]
  std::vector<Vec2> x_drag; ///< positions at which the drag of the matrix is taken, a little behind x; empty: at x [um]
};

/// A point of model time.
struct Instant {
  std::uint64_t step = 0; ///< steps done
  double t = 0.0;         ///< [s]
};

/// The whole simulation at one time: all that is needed to go on. Without cells it is the matrix alone.
struct State {
  std::uint64_t step = 0; ///< steps done
  double t = 0.0;         ///< [s]
  EcmState ecm;
  std::vector<Cell> cells;
  SolverMemory solver_memory;

  Instant now() const { return {step, t}; }
};

} // namespace matrigrate
