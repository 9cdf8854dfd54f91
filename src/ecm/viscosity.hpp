#pragma once

#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "sph/kernel.hpp"
#include "state/ecm.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

/// Drag between two particles, viscous term of Heck et al. 2020, Eq. (2):
///   G_ij = t_z V_i V_j (mu_i + mu_j) (-x_ij . grad_i W_ij) / (|x_ij|^2 + 0.01 h^2) >= 0
/// The force on i is -G_ij (v_i - v_j): the weakly Laplacian form mu lap(v) of Morris et al. 1997. It acts along the
/// velocity difference, so it conserves linear momentum exactly and resists a rotation of a finite body.
/// @param r2       |x_ij|^2 [um^2]   @param W_slope  kernel.W_slope(|x_ij|) [1/um^4], <= 0
/// @param V        volume of either particle per depth [um^2]   @param mu  viscosity [nN s/um^2]   @param t_z  depth
/// [um]
/// @return         [nN s/um]
/// Test: tests/unit/ecm/viscosity_test.cpp
inline double pair_drag(double r2, double W_slope, double V, double mu, double t_z, double h) {
  return t_z * V * V * 2.0 * mu * (-W_slope) * r2 / (r2 + 0.01 * h * h);
}

/// Fills A with the drag of all pairs at the current positions, in single precision, and A.F with the drag of the
/// clamped particles on the free ones; forces are added to A.F afterwards. Rows of clamped particles ask for their
/// given velocity, those of particles without partners for none.
/// @param pattern  of a list that is valid for the positions of `ecm`, with its clamped particles
/// @param share    theta >= 0: the drag resists changes of the velocities of `ecm` too, theta times as much as the
///                 velocities; all is divided by 1 + theta, so that the coefficients are those without
void assemble_viscosity(const EcmState& ecm, const EcmParameters& p, const RowPattern& pattern, DragSystem& A,
                        double share = 0.0);

/// The drag of the matrix from step to step: only rows near particles that have moved are made anew, and their
/// coefficients have the same bits as if all were. Test: tests/unit/ecm/viscosity_test.cpp
class MatrixDrag {
public:
  /// Fills A as assemble_viscosity() does, with the drag at the positions x.
  /// @param pairs    the list of which `pattern` is made
  /// @param A        that of the call before, but for what is no drag of the matrix
  void assemble(const EcmState& ecm, std::span<const Vec2> x, const EcmParameters& p, const Adjacency& pairs,
                const RowPattern& pattern, DragSystem& A, double share);

  /// Makes rows anew in the next call: after those of the list, and so of the pattern, or coefficients in A have
  /// changed.   @param changed  1 for each row that has; empty: none
  void forget(std::span<const std::uint8_t> changed);

private:
  void mark(std::span<const Vec2> x, const Adjacency& pairs, const RowPattern& pattern);

  std::vector<Vec2> m_seen;            // where the particles were in the last call
  DoubleField m_x;                     // the same, framed by particles that are nowhere
  Field m_free;                        // 1, or 0 for given ones
  std::vector<std::uint8_t> m_marks;   // of the blocks that are made anew
  std::vector<std::uint8_t> m_changed; // rows of the pattern since the last call; empty: none
  NodeVectors m_v;
  DoubleField m_zero, m_drag; // minus the drag at the velocities of the last step
};

/// Squares of the reference lattice, eight spacings wide, whose drag is taken anew together: if each particle had its
/// own moment, those of neighbours would hardly ever coincide, and nearly all coefficients would change in each step.
/// Test: tests/unit/ecm/viscosity_test.cpp
class DragPatches {
public:
  /// @param X  reference positions [um]   @param spacing  of the lattice [um]
  DragPatches(std::span<const Vec2> X, double spacing);

  /// Sets x_drag, the positions at which the drag was last taken, to x for all particles of a patch in which one has
  /// moved further than `lag` [um] since; everywhere if x_drag has another size than x.
  void refresh(std::span<const Vec2> x, double lag, std::vector<Vec2>& x_drag) const;

private:
  std::vector<std::uint32_t>
      m_first; // patch k has the particles m_particle[m_first[k]] .. m_particle[m_first[k + 1] - 1]
  std::vector<std::uint32_t> m_particle;
};

} // namespace matrigrate
