#pragma once

#include "parameters/parameters.hpp"
#include "state/ecm.hpp"

#include <functional>
#include <vector>

/// The bodies that a simulation can start from: particles on a lattice, at rest and free of stress.
/// Test: tests/unit/state/initial_test.cpp
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

/// Whether a value of MatrixFields::obstacle makes a particle part of an obstacle.
inline bool in_obstacle(double value) { return value >= 0.5; }

/// Properties of a matrix as functions of the reference position [um]; what is not given stays uniform.
struct MatrixFields {
  std::function<double(const Vec2&)> E_ratio{};           ///< Young's modulus over ecm.youngs_modulus, > 0 [-]
  std::function<double(const Vec2&)> f_degr{};            ///< at the start, in [0, 1]; never raises f [-]
  std::function<double(const Vec2&)> fibre_direction{};   ///< of uniaxial fibres, from the x axis [rad]
  std::function<double(const Vec2&)> fibre_ratio{};       ///< stiffness of fibres over fibres.stiffness, >= 0 [-]
  std::function<double(const Vec2&)> ligand{};            ///< over the usual, >= 0 [-]
  std::function<double(const Vec2&)> attractant{};        ///< concentration at the start, >= 0 [-]
  std::function<double(const Vec2&)> attractant_source{}; ///< release, >= 0 [1/s]
  std::function<double(const Vec2&)> obstacle{};          ///< in [0, 1]; from 1/2 on part of a rigid obstacle [-]
};

/// Gives the particles of a matrix at rest their properties; clamped ones stay solid, those of obstacles become clamped
/// and solid (MODEL.md, I33).
/// @throws std::invalid_argument naming the place of a value that is out of range or not finite
void apply(const MatrixFields& fields, EcmState& ecm);

} // namespace matrigrate
