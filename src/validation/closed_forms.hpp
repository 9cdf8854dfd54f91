#pragma once

#include "base/vector.hpp"
#include "ecm/law/material.hpp"
#include "parameters/parameters.hpp"
#include "sph/kernel.hpp"

#include <span>

/// What the matrix should do, on paper. Test: tests/unit/validation/validation_test.cpp
namespace matrigrate::validation {

/// Displacement at `x` by a force at the centre of a disc clamped at radius a, plane strain [um]. Kelvin's solution
/// plus the regular Michell terms r^0 and r^3 cos(theta) that cancel it on the rim (Barber, Elasticity, tables 8.1
/// and 9.1).
/// @param force  per depth [nN/um]   @param x  [um], not 0   @param a  [um]
Vec2 clamped_disc_displacement(const Vec2& force, const Vec2& x, double a, double G, double nu);

/// Mean displacement over a kernel at the centre of that disc, along a unit force spread over the same kernel [um/nN
/// per um of depth]: what a point of the continuum that is loaded and read like an adhesion would have for compliance.
/// Off-centre parts of the load take the solution of a central one: an error of order (h/a)^2.
double clamped_disc_compliance(const Kernel& kernel, double a, double G, double nu);

/// Viscosity that the pair drag of Eq. (2) has for long waves on the ideal lattice: mu times a lattice sum that is
/// slightly below 1, since eta = 0.01 h^2 is added to |x_ij|^2 and the kernel is sampled at few points [nN s/um^2].
double lattice_viscosity(const EcmParameters& p);

/// The same sum on the lattice after a simple shear along its rows, for a velocity along x that varies with y.
/// @param shear  dx/dy [-]
double sheared_lattice_viscosity(const EcmParameters& p, double shear);

/// Slope of the straight line through points by least squares.
double fit_slope(std::span<const double> x, std::span<const double> y);

/// Time constant of y = y_end - A exp(-t/tau) from its logarithmic slope where 5 % to 95 % of the way is done.
double fit_time_constant(std::span<const double> t, std::span<const double> y, double y_end);

} // namespace matrigrate::validation
