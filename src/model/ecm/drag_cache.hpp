#pragma once

#include "ecm/loop/viscosity.hpp"
#include "sph/neighbours.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace matrigrate {

/// Tiles of the reference lattice, eight by eight particles, whose drag coefficients are refreshed together: refreshing
/// particle by particle would touch nearly all coefficients in every step (MODEL.md, I30).
/// Test: tests/unit/ecm/ecm_test.cpp
class DragTiles {
public:
  /// @param X  reference positions [um]   @param spacing  of the lattice [um]
  DragTiles(std::span<const Vec2> X, double spacing);

  /// Finds where to evaluate the drag coefficients: at x in every tile in which a particle is further than `lag` from
  /// where they were last evaluated, and there in the other tiles.
  /// @param before  where they were last evaluated; x everywhere if it has another size   All are in um.
  void refresh(std::span<const Vec2> x, double lag, std::span<const Vec2> before, std::vector<Vec2>& x_drag) const;

private:
  std::vector<std::uint32_t>
      m_first; // tile k has the particles m_particle[m_first[k]] .. m_particle[m_first[k + 1] - 1]
  std::vector<std::uint32_t> m_particle;
};

/// Data kept between steps for the drag of the matrix. It is derived from the state alone: a new cache gives the same
/// bits. Test: tests/unit/ecm/ecm_test.cpp
class DragCache {
public:
  DragCache(const EcmState& ecm, const EcmParameters& p) : m_tiles(ecm.X, p.particle_spacing) {}

  /// Fills A as assemble_viscosity() does, with the drag evaluated at positions at most `lag` away from those of `ecm`.
  /// @param neighbours  valid for `ecm`; the same object in every call
  /// @param x_drag      positions at which the drag was evaluated in the last step; empty: none [um]
  /// @param A           the system of the previous call, if any
  void assemble(const EcmState& ecm, const EcmParameters& p, const VerletList& neighbours, std::span<const Vec2> x_drag,
                double lag, double theta, DragSystem& A);

  /// Positions at which assemble() evaluated the drag [um]; it does not need them again.
  std::vector<Vec2>& x_drag() { return m_x_drag; }

private:
  std::vector<std::uint8_t> refresh_pattern(const VerletList& neighbours, std::span<const std::uint8_t> clamped);

  DragTiles m_tiles;
  std::vector<Vec2> m_x_drag;
  RowPattern m_pattern;           // of the neighbours
  std::size_t m_updates_seen = 0; // of the neighbours
  ViscosityRows m_rows;
};

} // namespace matrigrate
