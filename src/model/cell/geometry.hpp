#pragma once

#include "base/vector.hpp"
#include "parameters/parameters.hpp"
#include "state/cortex.hpp"

#include <cstdint>
#include <vector>

/// The shape of the ring of cortex particles. Test: tests/unit/cell/geometry_test.cpp
namespace matrigrate {

/// Area inside the ring, positive for a counter-clockwise one [um^2].
double area(const CortexState& c);

/// Derivative of the area with respect to the position of particle i: half the chord of its neighbours, turned outwards
/// [um].
Vec2 area_gradient(const CortexState& c, std::size_t i);

/// Length of the ring [um].
double perimeter(const CortexState& c);

/// Centre of mass of the area inside the ring [um].
Vec2 centroid(const CortexState& c);

/// Centre of mass of the cell: the mean of its cortex particles (MODEL.md, I41) [um].
Vec2 centre_of_mass(const CortexState& c);

/// Outward unit normal at particle i, perpendicular to the chord of its neighbours.
Vec2 normal(const CortexState& c, std::size_t i);

/// Outward unit normals of all particles.
std::vector<Vec2> normals(const CortexState& c);

/// Signed curvature of the circle through particle i and those three further to either side, convex positive (MODEL.md,
/// I14) [1/um].
double curvature(const CortexState& c, std::size_t i);

/// Point of a segment that is closest to p.
struct ClosestPoint {
  double s;  ///< position along the segment, 0 at its first end and 1 at its second [-]
  Vec2 from; ///< p minus the closest point [um]
};
ClosestPoint closest_point(const Vec2& p, const Vec2& a, const Vec2& b);

/// Whether any two segments that are no neighbours cross.
bool crosses_itself(const CortexState& c);

/// Whether p lies inside the ring (even-odd rule).
bool contains(const CortexState& c, const Vec2& p);

/// For each particle whether it belongs to the front: the half of all particles that lies furthest along the
/// polarization (Heck et al. 2020, section "Polarization").
/// @param polarization  angle of d_pol [rad]
std::vector<std::uint8_t> front(const CortexState& c, double polarization);

} // namespace matrigrate
