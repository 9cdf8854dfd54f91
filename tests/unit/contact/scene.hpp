#pragma once

// A round cell in a hole of the matrix, and helpers to look at what the contact does to both.

#include "../cell/ring.hpp"
#include "contact/proximity.hpp"
#include "state/initial.hpp"

namespace matrigrate {

inline Parameters small_scene() {
  Parameters p;
  p.cell = small_cell();
  p.ecm.radius = 20.0;
  return p;
}

struct Scene {
  Parameters p = small_scene();
  EcmState ecm = disc(p);
  CortexState c = round_cortex(p.cell);
  double reach = 2.0 * p.ecm.smoothing_length;

  std::uint32_t first() const { return static_cast<std::uint32_t>(ecm.size()); } ///< node of particle 0 of the cortex

  std::vector<NearbyParticle> nearby() const { return nearby_solid(ecm, c, SegmentGrid(c, reach), reach); }

  std::vector<Vec2> positions() const {
    std::vector<Vec2> x = ecm.x;
    x.insert(x.end(), c.x.begin(), c.x.end());
    return x;
  }
};

/// The matrix intact up to the cell, that cell wavy: particles lie inside it, in reach and out of it.
inline Scene touching_scene() {
  Scene s;
  std::fill(s.ecm.f.begin(), s.ecm.f.end(), 1.0);
  s.c = wavy_cortex(s.p.cell);
  for (Vec2& x : s.c.x) x -= Vec2(3.0, -2.0); // back to the middle
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    if (s.ecm.x[i].x() < 0.0 && !s.ecm.clamped[i]) s.ecm.f[i] = 0.4;
  return s;
}

inline Scene moved(Scene s, const Motion& motion) {
  s.c = moved(s.c, motion);
  for (Vec2& x : s.ecm.x) x = motion(x);
  return s;
}

} // namespace matrigrate
