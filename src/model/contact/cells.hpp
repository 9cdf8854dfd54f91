#pragma once

#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/state.hpp"

#include <cstdint>
#include <span>
#include <vector>

/// Contact of cells with each other: repulsion and adhesion (MODEL.md, I38 and I39). Not part of Heck et al. 2020, who
/// have one cell. Test: tests/unit/contact/cells_test.cpp
namespace matrigrate {

/// A particle of one cell near the cortex of another.
struct CellTouch {
  std::uint32_t cell;     ///< whose particle it is, an index into State::cells
  std::uint32_t particle; ///< of its cortex
  std::uint32_t other;    ///< the cell that is near
  std::uint32_t segment;  ///< of its cortex, the closest one
  double s;               ///< closest point along the segment, 0 at its first end and 1 at its second [-]
  double gap;             ///< distance from the segment; negative inside the other cell [um]
  Vec2 normal;            ///< unit vector of growing gap, at the particle
};

/// Pressure between two cortices at a gap d, repulsion positive [kPa]:
///   q (1 - d/r) for d < r;   -a (1 - |2 (d - r)/w - 1|) for r <= d < r + w;   else 0,
/// with q = contact.cells.repulsion, r = range, a = adhesion, w = adhesion_range.   @param gap  [um]
double cell_pressure(double gap, const CellContactParameters& p);

/// Largest gap at which two cells feel each other: r, or r + w with adhesion [um].
double cell_reach(const CellContactParameters& p);

/// Particles closer to the cortex of another cell than a reach, on either side; both cells of a pair have theirs. In
/// ascending order of cell, other cell and particle. The time is linear in the number of cells.
/// @param reach  [um], > 0
std::vector<CellTouch> cell_touches(std::span<const Cell> cells, double reach);

/// Adds cell_pressure() times half of l_0,init t_z along the normal to each particle, and its reaction to the ends of
/// the segment: both cortices of a contact carry half of it. Linearly implicit along the normal where the pressure
/// falls with the gap.
/// @param dt  [s]   @param force  of all nodes [nN]
void add_cell_contact(const State& s, std::span<const CellTouch> touches, const Parameters& p, double dt,
                      std::span<Vec2> force, DragSystem& A);

} // namespace matrigrate
