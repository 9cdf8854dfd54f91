#pragma once

#include "parameters/laws/laws.hpp"
#include "parameters/parameters.hpp"
#include "state/cell.hpp"

#include <optional>

/// Polarization of the cell (Heck et al. 2020, section "Polarization"; MODEL.md, I21).
/// Test: tests/unit/protrusion/protrusion_test.cpp
namespace matrigrate {

/// Angle of the mean direction from the centre of mass to the mature adhesions, or none without them [rad].
/// @param centre  centre of mass of the cell [um]
std::optional<double> adhesion_direction(const Cell& cell, const Vec2& centre);

/// The angle after dt of turning towards `target`, the shorter way: at r_pol times the angle between them [rad]. A law
/// that a user has changed gives the rate for the angle as it is.
double turned(double angle, double target, double dt, const PolarizationParameters& p,
              const Law& law = usual_laws().polarization_rate);

/// Turns d_pol for dt.
void polarize(Cell& cell, const PolarizationParameters& p, const Vec2& centre, double dt,
              const Law& law = usual_laws().polarization_rate);

} // namespace matrigrate
