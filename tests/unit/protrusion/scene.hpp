#pragma once

// The round cell in the matrix, with protrusions in a given phase.

#include "../cell/ring.hpp"
#include "cell/geometry.hpp"
#include "state/initial.hpp"
#include "state/state.hpp"

namespace matrigrate {

inline State cell_in_matrix(const Parameters& p) {
  State s;
  s.ecm = disc(p);
  s.cortex = round_cortex(p.cell);
  return s;
}

inline Parameters small_matrix() {
  Parameters p;
  p.ecm.radius = 40.0;
  return p;
}

inline Protrusion& add_protrusion(State& s, std::uint32_t centre, const Phase& phase) {
  Protrusion born{.centre = centre, .since = s.t, .phase = phase, .record = {}};
  born.record.id = ++s.initiated;
  born.record.centre = centre;
  born.record.t_initiation = s.t;
  s.protrusions.push_back(born);
  return s.protrusions.back();
}

/// Outward direction of a particle of the round cell.
inline Vec2 outward(const State& s, std::size_t i) { return s.cortex.x[i].normalized(); }

} // namespace matrigrate
