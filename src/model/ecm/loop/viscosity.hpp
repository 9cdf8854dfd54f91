#pragma once

#include "ecm/law/viscosity.hpp"
#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/ecm.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

/// Fills A with the drag of all pairs at the current positions, in single precision, and A.F with the drag of the
/// clamped particles on the free ones; forces are added to A.F afterwards. The row of a clamped particle prescribes its
/// velocity; the row of a particle without neighbours prescribes velocity 0.
/// @param pattern  of a neighbour list that is valid for the positions of `ecm`, with its clamped particles
/// @param theta    >= 0: additional drag on changes of the velocities of `ecm`, theta times the drag on velocities.
///                 The system is divided by 1 + theta, so that the coefficients do not depend on theta
void assemble_viscosity(const EcmState& ecm, const EcmParameters& p, const RowPattern& pattern, DragSystem& A,
                        double theta = 0.0);

/// The same, incrementally from step to step: only rows near particles that have moved are recomputed. The result has
/// the same bits as a full assembly. Test: tests/unit/ecm/loop/loop_test.cpp
class ViscosityRows {
public:
  /// Fills A with the drag at the positions x.
  /// @param pairs    the neighbour list of `pattern`
  /// @param changed  1 for each row of the list that has changed since the previous call; empty: none
  /// @param A        the system of the previous call; rows with later additions are marked in A.touched
  void assemble(const EcmState& ecm, std::span<const Vec2> x, const EcmParameters& p, const Adjacency& pairs,
                const RowPattern& pattern, std::span<const std::uint8_t> changed, double theta, DragSystem& A);

private:
  void mark_moved(std::span<const Vec2> x, const Adjacency& pairs, const RowPattern& pattern);
  void mark_changed(const RowPattern& pattern, std::span<const std::uint8_t> changed, DragSystem& A);
  void add_relaxation(const EcmState& ecm, double theta, DragSystem& A);

  std::vector<Vec2> m_x_seen;        // positions in the last call
  DoubleField m_x;                   // the same, padded with particles out of reach
  Field m_free;                      // 0 for particles with a prescribed velocity, else 1
  std::vector<std::uint8_t> m_stale; // 1 for the blocks of rows to recompute
  NodeVectors m_v;
  DoubleField m_zero, m_drag; // minus the drag at the velocities of the last step
};

} // namespace matrigrate
