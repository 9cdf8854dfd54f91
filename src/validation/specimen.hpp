#pragma once

#include "simulation/simulation.hpp"

/// Specimens that the cases share.
namespace matrigrate::validation {

/// With a disc of this radius [um] that has no hole for a cell.
Parameters with_disc(Parameters p, double radius);

/// Where the rim holds a disc, known to within a spacing [um].
double clamp_radius(const EcmParameters& p);

/// Displacement over load of the centre of a disc that is a continuum, loaded and read with a kernel of this width
/// [um/nN].
double continuum_compliance(const EcmParameters& p, double width);

/// A uniform body force on all free particles. @param b  force per volume [nN/um^3]
Loads body_force(const Parameters& p, const Vec2& b);

/// Gives the clamped particles the velocity v(X) [um/s].
void move_clamped(EcmState& ecm, const std::function<Vec2(const Vec2&)>& v);

/// Moves the clamped particles by u(X) at a constant speed, then holds them. The stress follows from rates, so a
/// displacement must be driven; a jump would leave none.
void drive_clamped(Simulation& a, const std::function<Vec2(const Vec2&)>& u, double seconds, const Loads& loads = {});

/// Mean displacement of the free particles no further than half a row from y = 0 [um].
Vec2 mid_displacement(const EcmState& ecm, const EcmParameters& p);

/// Distance between the innermost clamped rows of a strip [um]: the walls, known to within a spacing.
double wall_distance(const EcmState& ecm);

/// A round cell in a small disc of matrix whose only protrusion has just begun to grow; its adhesion does not
/// disassemble. The cell starts off the centre, so that the tip stays clear of the rim.
struct SingleProtrusion : Simulation {
  /// @param material  and numerics; the radius of the disc is set here
  /// @param angle     direction of growth [rad]
  SingleProtrusion(const Parameters& material, double angle);

  double length() const; ///< l_prot now, from the middle of the base to the tip [um]
  const Cell& cell() const { return s.cells.front(); }
  const Protrusion& protrusion() const { return cell().protrusions.front(); }
};

} // namespace matrigrate::validation
