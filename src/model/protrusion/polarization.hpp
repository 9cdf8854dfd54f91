#pragma once

#include "parameters/laws/law.hpp"
#include "parameters/parameters.hpp"
#include "state/cell.hpp"

#include <optional>

/// Polarization of the cell (Heck et al. 2020, section "Polarization"; MODEL.md, I21).
/// Test: tests/unit/protrusion/protrusion_test.cpp
namespace matrigrate {

/// Angle of the mean direction from the centre of mass to the mature adhesions, or none without them [rad].
/// @param centre  centre of mass of the cell [um]
std::optional<double> adhesion_direction(const Cell& cell, const Vec2& centre);

/// The angle after dt of turning towards `target`, the shorter way: at the rate of the law, for the angle as it is,
/// times the angle between them [rad].   @param law  laws.polarization_rate
double turned(double angle, double target, double dt, const Law& law, const LawPlace& place = {});

/// Turns d_pol for dt.   @param place  of the centre
void polarize(Cell& cell, const Vec2& centre, double dt, const Law& law, const LawPlace& place = {});

} // namespace matrigrate
