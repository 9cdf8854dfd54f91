/// What      A cell among Table 1's matrix for ten minutes: where its centre of mass is, every two minutes.
/// Equation  Eqs. (1) to (7) of Heck et al. 2020, all of the model.
/// Check     It has moved, but by less than its radius: protrusions grow for 400 s before they can pull it.
/// Libraries Matrigrate::simulation
#include "cell/geometry.hpp"
#include "simulation/simulation.hpp"

#include <fmt/format.h>

int main() {
  matrigrate::Parameters p;
  p.ecm.radius = 60.0; // [um]
  matrigrate::Simulation simulation(p);
  matrigrate::Vec2 centre;
  for (double t = 120.0; t <= 600.0; t += 120.0) {
    simulation.march(t);
    centre = centre_of_mass(simulation.s.cells.front().cortex);
    fmt::print("{:4.0f} s: ({:.2f}, {:.2f}) um\n", simulation.s.t, centre.x(), centre.y());
  }
  return centre.norm() > 0.1 && centre.norm() < p.cell.radius ? 0 : 1;
}
