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
/// clamped particles on the free ones; forces are added to A.F afterwards. Rows of clamped particles ask for their
/// prescribed velocity, those of particles without partners for none.
/// @param pattern  of a list that is valid for the positions of `ecm`, with its clamped particles
/// @param theta    >= 0: the drag resists changes of the velocities of `ecm` too, theta times as much as the
/// velocities;
///                 all is divided by 1 + theta, so that the coefficients are those without
void assemble_viscosity(const EcmState& ecm, const EcmParameters& p, const RowPattern& pattern, DragSystem& A,
                        double theta = 0.0);

/// The same from step to step: only rows near particles that have moved are computed again, and all have the same bits
/// as if they were. Test: tests/unit/ecm/viscosity_test.cpp
class ViscosityRows {
public:
  /// Fills A with the drag at the positions x.
  /// @param pairs    the list of which `pattern` is made
  /// @param changed  1 for each row of the list that has changed since the call before; empty: none
  /// @param A        that of the call before; rows that have been added to since are marked in A.touched
  void assemble(const EcmState& ecm, std::span<const Vec2> x, const EcmParameters& p, const Adjacency& pairs,
                const RowPattern& pattern, std::span<const std::uint8_t> changed, double theta, DragSystem& A);

private:
  void mark_moved(std::span<const Vec2> x, const Adjacency& pairs, const RowPattern& pattern);
  void mark_changed(const RowPattern& pattern, std::span<const std::uint8_t> changed, DragSystem& A);
  void add_relaxation(const EcmState& ecm, double theta, DragSystem& A);

  std::vector<Vec2> m_x_seen;        // positions in the last call
  DoubleField m_x;                   // the same, framed by particles that are nowhere
  Field m_free;                      // 1, or 0 for particles whose velocity is prescribed
  std::vector<std::uint8_t> m_stale; // 1 for the blocks of rows to compute
  NodeVectors m_v;
  DoubleField m_zero, m_drag; // minus the drag at the velocities of the last step
};

} // namespace matrigrate
