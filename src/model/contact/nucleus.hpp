#pragma once

#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cell.hpp"

#include <cstdint>
#include <span>
#include <vector>

/// What joins the nucleus of a cell to its cortex: contact from inside, and the filaments that hold it in the middle
/// (MODEL.md, I40). Forces on the two sum to zero. Test: tests/unit/contact/nucleus_test.cpp
namespace matrigrate {

/// A particle of the nucleus near the cortex, or one of the cortex near the nucleus.
struct NucleusTouch {
  bool of_nucleus;        ///< whose particle it is; the segment belongs to the other ring
  std::uint32_t particle; ///< of its ring
  std::uint32_t segment;  ///< of the other ring, the closest one
  double s;               ///< closest point along the segment, 0 at its first end and 1 at its second [-]
  double gap;             ///< between nucleus and cortex; negative where they overlap [um]
  Vec2 normal;            ///< unit vector of growing gap, at the particle
};

/// Pressure between nucleus and cortex at a gap d, q (1 - d/r) for d < r, else 0, with q = nucleus.repulsion and r =
/// nucleus.repulsion_range: the law of cell_pressure() [kPa].   @param gap  [um]
double nucleus_pressure(double gap, const NucleusParameters& n);

/// Particles of either ring that lie closer to the other one than nucleus.repulsion_range, or overlap with it by less
/// than twice that; none without a nucleus. First those of the nucleus, in ascending order.
std::vector<NucleusTouch> nucleus_touches(const Cell& cell, const NucleusParameters& n);

/// Adds nucleus_pressure() times half of a particle's area, l_0,init t_z, along the normal to each particle, and its
/// reaction to the ends of the segment. Linearly implicit along the normal.
/// @param cortex, nucleus  nodes of their particles 0   @param dt  [s]   @param force  of all nodes [nN]
void add_nucleus_contact(const Cell& cell, std::span<const NucleusTouch> touches, const Parameters& p, double dt,
                         std::uint32_t cortex, std::uint32_t nucleus, std::span<Vec2> force, DragSystem& A);

/// From the mean of the particles of the nucleus to that of the cortex [um].
Vec2 off_centre(const Cell& cell);

/// Adds k_c times off_centre() to the nucleus, in equal parts to its particles, and the reaction to the cortex
/// likewise; with k_c = nucleus.centring_stiffness. Their mean velocities are coupled by nucleus.drag + dt k_c. Both
/// forces act along the line through the means, so they have no moment.
/// @param cortex, nucleus  nodes of their particles 0   @param force  of all nodes [nN]
void add_centring(const Cell& cell, const NucleusParameters& n, double dt, std::uint32_t cortex, std::uint32_t nucleus,
                  std::span<Vec2> force, DragSystem& A);

/// Whether a particle of the nucleus lies outside of the cortex.
bool nucleus_outside(const Cell& cell);

} // namespace matrigrate
