#pragma once

#include "base/vector.hpp"
#include "sph/kernel.hpp"
#include "state/ecm.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

/// Interpolation weights of a point of the solid: kernel times f_degr and ligand, normalised to sum 1. A force at the
/// point is distributed to the particles with these weights, and the point moves with the weighted mean velocity. Test:
/// tests/unit/sph/sph_test.cpp
struct PointWeights {
  std::vector<std::uint32_t> index;
  std::vector<double> weight;
  double support =
      0.0; ///< sum of V_0 f L W before normalising: about 1 in intact matrix, 0 where there is no solid [-]
};

/// @param point  [um]
PointWeights solid_weights(const EcmState& ecm, const Kernel& kernel, const Vec2& point);

/// The same with the particles at their reference positions: the surroundings of a material point, whose weights change
/// with f_degr alone.   @param point  in the reference configuration [um]
PointWeights material_weights(const EcmState& ecm, const Kernel& kernel, const Vec2& point);

/// Distributes `force` [nN] at the point to the particles, adding to F.
void spread(const PointWeights& w, const Vec2& force, std::span<Vec2> F);

/// Weighted mean of a field of the particles: velocity or displacement of the point.
Vec2 interpolate(const PointWeights& w, std::span<const Vec2> field);

} // namespace matrigrate
