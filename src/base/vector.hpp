#pragma once

#include <Eigen/Core>

#include <cmath>

namespace matrigrate {

/// A point, displacement, velocity [um, um/s] or force [nN] of the plane model.
using Vec2 = Eigen::Vector2d;
/// A second-order tensor of the plane: deformation gradient [-], velocity gradient [1/s], stress [kPa].
using Mat2 = Eigen::Matrix2d;

/// Out-of-plane component of a x b.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// a turned by +90 degrees.
inline Vec2 perpendicular(const Vec2& a) { return {-a.y(), a.x()}; }

/// a - b along the nearest image of a lattice that repeats along x with `period` (0: does not) [um].
inline Vec2 nearest_image(Vec2 a_minus_b, double period) {
  if (period > 0.0) a_minus_b.x() -= period * std::nearbyint(a_minus_b.x() / period);
  return a_minus_b;
}

/// Doubly contracted product A : B.
inline double contraction(const Mat2& A, const Mat2& B) { return A.cwiseProduct(B).sum(); }

} // namespace matrigrate
