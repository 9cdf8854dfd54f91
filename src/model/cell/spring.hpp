#pragma once

#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cortex.hpp"

#include <cstdint>
#include <span>

namespace matrigrate {

// Springs and dashpots of the cortex, Heck et al. 2020, Eq. (1), terms F^s and F^d. Test:
// tests/unit/cell/cell_test.cpp

/// Tension of a spring, both ways: k (l - l_0) [nN].
inline double spring_tension(double k, double l, double l0) { return k * (l - l0); }

/// Resistance of a crowded segment, one shorter than l_c = crowding x l_0,init: -k_s l_c (l_c/l - 1), never positive;
/// it keeps segments from collapsing under any load (MODEL.md, I10) [nN].
double crowding_tension(double l, const CellParameters& p);

/// Its energy over all segments, sum of k_s l_c (l - l_c - l_c ln(l/l_c)) [nN um].
double crowding_energy(const CortexState& c, const CellParameters& p);

/// Energy of all springs, sum of k (l - l_0)^2 / 2 [nN um].
/// @param k  stiffness of each segment [nN/um]
double spring_energy(const CortexState& c, std::span<const double> k);

/// Adds the forces of springs and crowding, and the dashpots eta_c dl/dt. Treated linearly implicitly: the drag along a
/// segment is eta_c + dt (slope of the tension), and across it dt (tension)/l where it pulls (MODEL.md, I10).
/// @param k      stiffness of each segment [nN/um]
/// @param first  node of particle 0
/// @param force  of all nodes [nN]
void add_springs(const CortexState& c, const CellParameters& p, std::span<const double> k, double dt,
                 std::uint32_t first, std::span<Vec2> force, DragSystem& A);

/// Adds a tension T >= 0 [nN] between the ends of segment i, with its drag dt T/l across the segment.
void add_tension(const CortexState& c, std::size_t i, double T, double dt, std::uint32_t first, std::span<Vec2> force,
                 DragSystem& A);

/// Adds a dashpot `drag` [nN s/um] between the ends of segment i.
void add_dashpot(const CortexState& c, std::size_t i, double drag, std::uint32_t first, DragSystem& A);

// Memory of the cortex: stretched segments do not spring out again once they have shortened (Heck et al. 2020, section
// "Protrusion retraction"). Test: tests/unit/cell/cell_test.cpp

/// Rest length after a step: l where l_0,init <= l < l_0, else l_0 [um].
inline double ratcheted(double l0, double l, double l0_init) { return l0_init <= l && l < l0 ? l : l0; }

/// Ratchets the rest lengths of all segments but the soft ones.
/// @param soft  1 for the segments of growing and maturing protrusions
void ratchet_rest_lengths(CortexState& c, const CellParameters& p, std::span<const std::uint8_t> soft);

} // namespace matrigrate
