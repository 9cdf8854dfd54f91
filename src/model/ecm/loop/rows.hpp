#pragma once

#include "base/adjacency.hpp"
#include "base/vector.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Sums over reference neighbours for many particles at once. Test: tests/unit/ecm/loop/loop_test.cpp
namespace matrigrate {

/// A run of consecutive particles that share one neighbour stencil: partner k has the same index offset and the same
/// separation for all of them. On a lattice, runs are its rows. Ragged rows collect particles at the edge of a body;
/// missing partners are masked.
struct ParticleRow {
  static constexpr std::size_t longest = 128;

  std::uint32_t begin = 0;    ///< first particle
  std::uint32_t count = 0;    ///< particles, at most `longest`; of a ragged row at most `lanes`
  std::uint32_t first = 0;    ///< the first partner, in ParticleRows
  std::uint32_t partners = 0; ///< partners of each particle
  bool ragged = false;
};

/// One entry of the stencil of a row.
struct RowPartner {
  std::ptrdiff_t distance; ///< partner minus particle
  double half_X, half_Y;   ///< X_ij/2 = (X_i - X_j)/2 [um]
  double grad_x, grad_y;   ///< grad_0 W_ij [1/um^3]
  double w, w_X, w_Y;      ///< w_ij = W_0,ij/|X_ij|^2 [1/um^4], w_ij X_ij [1/um^3]
};

/// What the reference separation of two particles decides.
struct Separation {
  Vec2 X;           ///< X_ij = X_i - X_j [um]
  Vec2 grad_W;      ///< grad_0 W_ij [1/um^3]
  double W_over_r2; ///< W_0,ij/|X_ij|^2 [1/um^4]
};

/// The separations of all pairs of a list. A lattice has few different ones.
struct PairSeparations {
  std::vector<Separation> different;
  std::vector<std::uint32_t> of_pair; ///< index into `different`, parallel to the list's index

  const Separation& operator[](std::uint32_t k) const { return different[of_pair[k]]; }
};

/// A row with its stencil: the terms of its sums.
struct RowTerms {
  ParticleRow row;
  std::span<const RowPartner> partners;
  const double* has; ///< mask of a ragged row: `lanes` numbers per partner, 1 for the particles that have it, else 0
};

/// All particles, divided into rows in index order.
class ParticleRows {
public:
  /// Number of particles whose sums are computed together in SIMD registers.
  static constexpr std::size_t lanes = 8;

  ParticleRows() = default;

  ParticleRows(const Adjacency& pairs, const PairSeparations& separations);

  std::size_t size() const { return m_rows.size(); }
  RowTerms terms(std::size_t r) const {
    const ParticleRow& row = m_rows[r];
    return {row, {m_partners.data() + row.first, row.partners}, m_has.data() + lanes * row.first};
  }

private:
  void add_row(std::uint32_t begin, std::uint32_t count, const Adjacency& pairs, const PairSeparations& separations);
  void add_ragged(std::uint32_t begin, std::uint32_t count, const Adjacency& pairs, const PairSeparations& separations);

  std::vector<ParticleRow> m_rows;
  std::vector<RowPartner> m_partners;
  std::vector<double> m_has;
};

/// One number per particle, padded with zeros at both ends: a read of `lanes` numbers that starts at any particle, or
/// ends before it, stays inside.
class Plane {
public:
  void resize(std::size_t n) { m_values.resize(n + 2 * ParticleRows::lanes); }
  double* data() { return m_values.data() + ParticleRows::lanes; }
  const double* data() const { return m_values.data() + ParticleRows::lanes; }
  double& operator[](std::size_t i) { return data()[i]; }
  double operator[](std::size_t i) const { return data()[i]; }

private:
  std::vector<double> m_values;
};

/// A field of vectors or of tensors, component by component.
struct VectorPlanes {
  Plane x, y;

  void resize(std::size_t n);
  void set(std::size_t i, const Vec2& a) { x[i] = a.x(), y[i] = a.y(); }
  Vec2 operator[](std::size_t i) const { return {x[i], y[i]}; }
};

struct TensorPlanes {
  Plane xx, xy, yx, yy;

  void resize(std::size_t n);
  void set(std::size_t i, const Mat2& A) { xx[i] = A(0, 0), xy[i] = A(0, 1), yx[i] = A(1, 0), yy[i] = A(1, 1); }
  Mat2 operator[](std::size_t i) const { return (Mat2() << xx[i], xy[i], yx[i], yy[i]).finished(); }
};

/// Results for the particles of a row, in index order.
struct RowVectors {
  double x[ParticleRow::longest], y[ParticleRow::longest];

  Vec2 operator[](std::size_t t) const { return {x[t], y[t]}; }
};

struct RowTensors {
  double xx[ParticleRow::longest], xy[ParticleRow::longest], yx[ParticleRow::longest], yy[ParticleRow::longest];

  Mat2 operator[](std::size_t t) const { return (Mat2() << xx[t], xy[t], yx[t], yy[t]).finished(); }
  void set(std::size_t t, const Mat2& A) { xx[t] = A(0, 0), xy[t] = A(0, 1), yx[t] = A(1, 0), yy[t] = A(1, 1); }
};

/// Whether all of f are 1.
bool all_intact(std::span<const double> f);

/// Multiplies the first n tensors by a number.
void scale(double by, std::size_t n, RowTensors& A);

/// Sums that depend only on the degradation of the neighbours. A particle's own value times these sums is its
/// contribution to the sums below.
struct DegradationMoments {
  Vec2 grad_W = Vec2::Zero(); ///< sum_j f_j grad_0 W_ij
  double w = 0.0;             ///< sum_j f_j w_ij, w_ij = W_0,ij/|X_ij|^2
  Vec2 wX = Vec2::Zero();     ///< sum_j f_j w_ij X_ij
  Mat2 wXX = Mat2::Zero();    ///< sum_j f_j w_ij X_ij (x) X_ij
};

/// sum_j a_j (x) grad_0 W_ij.
void sum_gradient(const RowTerms& terms, const VectorPlanes& a, RowTensors& sum);

/// Sums of w_ij (H_j X_ij/2 + u_j), for the hourglass forces, and of the same (x) X_ij, for their moment.
void sum_hourglass(const RowTerms& terms, const VectorPlanes& u, const TensorPlanes& H, RowTensors& moment,
                   RowVectors& force);

/// sum_j Q_j grad_0 W_ij.
void sum_stress(const RowTerms& terms, const TensorPlanes& Q, RowVectors& sum);

} // namespace matrigrate
