#pragma once

#include "parameters/parameters.hpp"
#include "state/cell.hpp"
#include "state/ecm.hpp"

#include <functional>
#include <span>

/// Growth turns towards degraded matrix (Heck et al. 2020, section "Protrusion growth"; MODEL.md, I17).
/// Test: tests/unit/protrusion/protrusion_test.cpp
namespace matrigrate {

/// Angular speed of d_prot: r_defl times the mean, with kernel weights W(|r|), of (1 - f_degr) sin(angle from d_prot to
/// r) over the matrix particles at r from the foremost pushing particle that are further than the reach of tip
/// degradation, less than deflection_cone off d_prot and off the way the tip points, and not inside the cell [rad/s].
/// @param tip        position of the foremost pushing particle [um]
/// @param direction  d_prot, unit vector
/// @param ahead      where the tip points, unit vector: d_prot does not turn further away from it than the cone
/// @param inside     whether a point lies inside the cell: its tip cannot turn into its own body
double deflection_speed(const EcmState& ecm, const Parameters& p, const Vec2& tip, const Vec2& direction,
                        const Vec2& ahead, const std::function<bool(const Vec2&)>& inside);

/// Turns d_prot of all growing protrusions for dt.   @param normals  outward unit normals of the cortex particles
void deflect(Cell& cell, const EcmState& ecm, const Parameters& p, double dt, std::span<const Vec2> normals,
             const std::function<bool(const Vec2&)>& inside);

} // namespace matrigrate
