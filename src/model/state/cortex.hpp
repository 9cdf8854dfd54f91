#pragma once

#include "base/vector.hpp"
#include "parameters/parameters.hpp"

#include <cstddef>
#include <vector>

namespace matrigrate {

/// The cell's boundary at one time: a closed ring of particles, counter-clockwise. Segment i joins particle i to the
/// next one.
struct CortexState {
  std::vector<Vec2> x;    ///< positions of the particles [um]
  std::vector<Vec2> v;    ///< velocities of the last step [um/s]
  std::vector<double> l0; ///< rest lengths of the segments [um]

  std::size_t size() const { return x.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  std::size_t previous(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }

  /// Index of the particle `steps` along the ring from i.
  std::size_t along(std::size_t i, int steps) const {
    const auto n = static_cast<long>(size());
    return static_cast<std::size_t>(((static_cast<long>(i) + steps) % n + n) % n);
  }
  /// How many particles apart i and j are, the shorter way round.
  std::size_t apart(std::size_t i, std::size_t j) const {
    const std::size_t d = i > j ? i - j : j - i;
    return d < size() - d ? d : size() - d;
  }
};

/// The round cell of the start: cell.particles on a circle around (cell.start_x, cell.start_y), at rest, unstretched.
CortexState round_cortex(const CellParameters& p);

/// The same around another centre.
CortexState round_cortex(CellParameters p, const CellStart& start);

/// Length of a segment of the round cell, l_0,init [um].
double initial_segment_length(const CellParameters& p);

/// Area of the round cell (of its polygon), A_0 [um^2].
double initial_area(const CellParameters& p);

} // namespace matrigrate
