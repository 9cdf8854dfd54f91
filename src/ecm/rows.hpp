#pragma once

#include "base/adjacency.hpp"
#include "base/vector.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

/// Sums over reference neighbours for many particles at once. Test: tests/unit/ecm/rows_test.cpp
namespace matrigrate {

/// Consecutive particles whose neighbours lie alike: neighbour k of particle begin + t is t further than neighbour k of
/// particle begin, at the same distance. On a lattice these are its rows; at the edge of the body they are short.
struct ParticleRow {
  static constexpr std::size_t longest = 128;

  std::uint32_t begin = 0;    ///< first particle
  std::uint32_t count = 0;    ///< particles, at most `longest`
  std::uint32_t entry = 0;    ///< neighbour k is entry + k in the arrays beside the list of pairs
  std::uint32_t partners = 0; ///< neighbours of each particle
};

/// Cuts all particles into rows, in their order.
/// @param X_ij  reference separations beside pairs.index [um]
std::vector<ParticleRow> find_rows(const Adjacency& pairs, const std::vector<Vec2>& X_ij);

/// A field of vectors or of tensors, component by component.
struct VectorPlanes {
  std::vector<double> x, y;

  void resize(std::size_t n);
  void set(std::size_t i, const Vec2& a) { x[i] = a.x(), y[i] = a.y(); }
};

struct TensorPlanes {
  std::vector<double> xx, xy, yx, yy;

  void resize(std::size_t n);
  void set(std::size_t i, const Mat2& A) { xx[i] = A(0, 0), xy[i] = A(0, 1), yx[i] = A(1, 0), yy[i] = A(1, 1); }
  Mat2 operator[](std::size_t i) const { return (Mat2() << xx[i], xy[i], yx[i], yy[i]).finished(); }
};

/// Results for the particles of a row, in their order.
struct RowVectors {
  double x[ParticleRow::longest], y[ParticleRow::longest];

  Vec2 operator[](std::size_t t) const { return {x[t], y[t]}; }
};

struct RowTensors {
  double xx[ParticleRow::longest], xy[ParticleRow::longest], yx[ParticleRow::longest], yy[ParticleRow::longest];

  Mat2 operator[](std::size_t t) const { return (Mat2() << xx[t], xy[t], yx[t], yy[t]).finished(); }
};

/// What the sums go over; the arrays belong to Reference.
struct RowTerms {
  ParticleRow row;
  const std::uint32_t* index; ///< neighbours beside the entries
  const Vec2* X_ij;           ///< X_i - X_j beside the entries [um]
  const Vec2* grad_W;         ///< grad_0 W_ij beside the entries [1/um^3]
  const double* W_over_r2;    ///< W_0,ij / |X_ij|^2 beside the entries [1/um^4]
};

/// Sums that depend on the degradation of the neighbours alone: the same field times these is what a particle's own
/// value adds to the sums below.
struct DegradationMoments {
  Vec2 grad_W = Vec2::Zero(); ///< sum_j f_j grad_0 W_ij
  double w = 0.0;             ///< sum_j f_j w_ij, w_ij = W_0,ij/|X_ij|^2
  Vec2 wX = Vec2::Zero();     ///< sum_j f_j w_ij X_ij
  Mat2 wXX = Mat2::Zero();    ///< sum_j f_j w_ij X_ij (x) X_ij
};

/// sum_j a_j (x) grad_0 W_ij.
void sum_gradient(const RowTerms& terms, const VectorPlanes& a, RowTensors& sum);

/// sum_j w_ij (H_j X_ij/2 + u_j) (x) X_ij.
void sum_hourglass_moment(const RowTerms& terms, const VectorPlanes& u, const TensorPlanes& H, RowTensors& sum);

/// Sums of Q_j grad_0 W_ij (stress) and of w_ij (H_j X_ij/2 + u_j) (hourglass).
void sum_forces(const RowTerms& terms, const VectorPlanes& u, const TensorPlanes& H, const TensorPlanes& Q,
                RowVectors& stress, RowVectors& hourglass);

} // namespace matrigrate
