#pragma once

// The round cell in the matrix, with protrusions in a given phase.

#include "../cell/ring.hpp"
#include "cell/geometry.hpp"
#include "state/initial.hpp"
#include "state/state.hpp"

namespace matrigrate {

struct Scene {
  EcmState ecm;
  Cell cell;
  Instant now;

  std::size_t nodes() const { return ecm.size() + cell.cortex.size(); }
  std::uint32_t first() const { return static_cast<std::uint32_t>(ecm.size()); } ///< node of particle 0 of the cortex
  std::size_t node(std::size_t i) const { return ecm.size() + i; }
};

inline Cell round_cell(const Parameters& p) {
  Cell cell;
  cell.cortex = round_cortex(p.cell);
  return cell;
}

inline Scene cell_in_matrix(const Parameters& p) { return {.ecm = disc(p), .cell = round_cell(p), .now = {}}; }

inline Parameters small_matrix() {
  Parameters p;
  p.ecm.radius = 40.0;
  return p;
}

inline Protrusion& add_protrusion(Scene& s, std::uint32_t centre, const Phase& phase) {
  Protrusion born{.centre = centre, .since = s.now.t, .phase = phase, .record = {}};
  born.record.id = ++s.cell.initiated;
  born.record.centre = centre;
  born.record.t_initiation = s.now.t;
  s.cell.protrusions.push_back(born);
  return s.cell.protrusions.back();
}

inline void next_step(Scene& s, const Parameters& p) {
  ++s.now.step;
  s.now.t = static_cast<double>(s.now.step) * p.run.time_step;
}

/// Outward direction of a particle of the round cell.
inline Vec2 outward(const Scene& s, std::size_t i) { return s.cell.cortex.x[i].normalized(); }

} // namespace matrigrate
