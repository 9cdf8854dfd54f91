#pragma once

#include "base/adjacency.hpp"
#include "base/parallel.hpp"
#include "base/vector.hpp"
#include "ecm/loop/rows.hpp"
#include "parameters/parameters.hpp"
#include "state/ecm.hpp"

#include <span>
#include <vector>

namespace matrigrate {

/// The reference configuration of the solid (total-Lagrangian SPH): permanent neighbours, kernel values, and the
/// gradient correction (MODEL.md, I4). Derived from X and f_degr alone. Test: tests/unit/ecm/ecm_test.cpp
///
/// Support tensor     A_i = sum_j V_0 f_j (X_j - X_i) (x) grad_0 W_ij      (about the identity in intact matrix)
/// Correction         B_i = A_i^-1, eigenvalues of A_i below support_floor raised to it
/// Clamped particles  B_i of a full lattice: the clamp continues beyond the last row as a rigid, intact body.
/// The edge of a body is not damage: where the smallest eigenvalue of the intact A_i is below 1, support_floor and
/// orphan_support are relative to it.
class Reference {
public:
  Reference(const EcmState& ecm, const EcmParameters& p);

  /// Updates A, B and the moments to f_degr; recomputes only the neighbours of particles whose f changed.
  void update(const EcmState& ecm);

  const Adjacency& pairs() const { return m_pairs; }
  /// Calls body(terms) for every row of particles, with the terms of its sums over neighbours.
  template <class Body>
  void each_row(const Body& body) const {
    constexpr std::size_t grain = 8;
    parallel_for(
        m_rows.size(), [&](std::size_t r) { body(m_rows.terms(r)); }, grain);
  }

  const Vec2& X_ij(std::uint32_t k) const { return m_separations[k].X; }         ///< of entry k of pairs() [um]
  const Vec2& grad_W(std::uint32_t k) const { return m_separations[k].grad_W; }  ///< grad_0 W_ij of entry k [1/um^3]
  double W_over_r2(std::uint32_t k) const { return m_separations[k].W_over_r2; } ///< W_0,ij/|X_ij|^2 [1/um^4]
  const Mat2& B(std::size_t i) const { return m_B[i]; }                          ///< gradient correction [-]

  /// Sums over the neighbours of particle i at their current degradation.
  const DegradationMoments& moments(std::size_t i) const { return m_moments[i]; }

  /// Whether B and the moments of particle i are those of an intact lattice: multiples of the identity, or 0.
  bool whole(std::size_t i) const { return m_whole[i] != 0; }
  /// Whether particle i is intact, and all lattice neighbours exist and are intact.
  bool plain(const EcmState& ecm, std::size_t i) const { return whole(i) && ecm.f[i] == 1.0; }
  /// Calls body(begin, end, plain) for the stretches of a row whose particles are plain, or are not.
  template <class Body>
  void each_stretch(const EcmState& ecm, const ParticleRow& row, const Body& body) const {
    const std::size_t last = row.begin + row.count;
    for (std::size_t begin = row.begin, end = begin; begin < last; begin = end) {
      const bool is_plain = plain(ecm, begin);
      while (end < last && plain(ecm, end) == is_plain) ++end;
      body(begin, end, is_plain);
    }
  }
  double lattice_correction() const { return m_B_lattice(0, 0); }
  const DegradationMoments& lattice_moments() const { return m_lattice_moments; }

  /// Smallest eigenvalue of A_i, over that of the intact particle where it is below 1 [-].
  double relative_support(std::size_t i) const { return m_support[i]; }

private:
  Mat2 support_tensor(std::size_t i, std::span<const double> f, double V0) const;
  void correct(std::size_t i, const EcmState& ecm);

  double m_support_floor;
  Adjacency m_pairs;
  PairSeparations m_separations;
  ParticleRows m_rows;
  Mat2 m_B_lattice;
  std::vector<Mat2> m_B;
  std::vector<DegradationMoments> m_moments;
  DegradationMoments m_lattice_moments;
  std::vector<std::uint8_t> m_whole;
  std::vector<double> m_intact;  // min(1, smallest eigenvalue of A_i with all f = 1)
  std::vector<double> m_support; // smallest eigenvalue of A_i over the intact one
  std::vector<double> m_f_seen;  // the f for which m_B and m_moments hold
};

} // namespace matrigrate
