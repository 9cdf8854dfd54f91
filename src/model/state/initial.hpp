#pragma once

#include "parameters/parameters.hpp"
#include "state/matrix_field.hpp"

#include <vector>

/// The bodies that a simulation can start from: particles on a lattice, at rest and free of stress.
/// Test: tests/unit/state/state_test.cpp
namespace matrigrate {

/// Area of a particle: dp^2 on the square lattice, sqrt(3)/2 dp^2 on the hexagonal one [um^2].
double particle_area(const EcmParameters& ecm);

/// The lattice points around the origin, origin included, that lie within `reach` of it [um].
std::vector<Vec2> lattice_patch(const EcmParameters& ecm, double reach);

/// The matrix of the paper: a disc around the origin whose particles within 2h of the rim are clamped. With
/// ecm.cell_hole the disc of each cell and a margin of degradation.body_distance around it start as fluid (f = 0).
EcmState disc(const Parameters& p);

/// A layer between two rigid walls, periodic along x. The wall rows, of thickness 2h, lie outside `height`.
/// @param width   rounded up to whole columns [um]
/// @param height  rounded up to whole rows; the distance between the first wall rows is one spacing more [um]
EcmState strip(const EcmParameters& ecm, double width, double height);

/// A rectangle with free sides along x, held by grips at both ends: the particles within `grip` of an end are clamped.
/// The origin is its centre.
/// @param width   along x, grips included, rounded to whole columns [um]
/// @param height  along y, rounded to whole rows [um]
EcmState rectangle(const EcmParameters& ecm, double width, double height, double grip);

} // namespace matrigrate
