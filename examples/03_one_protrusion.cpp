/// What      A single protrusion grows into the matrix, with a picture of the cell at the end if a file is named:
///           03_one_protrusion cell.svg
/// Equation  Eqs. (1) and (2) of Heck et al. 2020 with the growth force F_prot; the tip degrades what is ahead of it.
/// Check     After T_prot = 400 s it has the length that the paper names, 25 to 30 um.
/// Libraries Matrigrate::simulation, Matrigrate::draw (the picture)
#include "base/file.hpp"
#include "cell/geometry.hpp"
#include "draw/particle_picture.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/initiation.hpp"
#include "simulation/simulation.hpp"

#include <fmt/format.h>

using namespace matrigrate;

int main(int argc, char** argv) {
  // A cell off the centre of a small disc, so that the tip stays clear of the rim. No protrusion begins by itself.
  Parameters p;
  p.ecm.radius = 70.0;
  p.cell.start_x = -20.0;
  p.protrusion.initiation_rate = 0.0;
  p.run.integrator = Integrator::adaptive;
  p.run.time_step = usual_time_step(p.run.integrator);

  // Particle 15 stands at 23 degrees: the protrusion grows away from the centre of mass, off the axes of the lattice,
  // along which protrusions are a little shorter.
  Simulation simulation(p);
  const State& s = simulation.s;
  constexpr std::size_t centre = 15;
  Cell& cell = simulation.s.cells.front();
  begin_protrusion(cell, centre, centre_of_mass(cell.cortex), s.t, p.protrusion);

  fmt::print("time [s]  length [um]\n");
  for (double t = 50.0; t < p.protrusion.growth_time; t += 50.0) {
    simulation.march(t);
    fmt::print("{:8.0f}  {:.2f}\n", s.t, protrusion_length(cell.cortex, centre, p.protrusion));
  }

  // Growth ends by itself: the tip adheres, and the record has the length at that moment.
  simulation.march(p.protrusion.growth_time + 10.0);
  const Protrusion& grown = cell.protrusions.at(0);
  fmt::print("{} since {:.1f} s, l_prot = {:.2f} um\n", name(grown.phase), grown.since, grown.record.length);
  if (argc > 1) {
    const draw::ParticlePicture picture{.title = "A protrusion and the matrix that it has degraded",
                                        .value_label = "intact matrix, f_degr: 0 fluid, 1 intact",
                                        .position = s.ecm.x,
                                        .value = s.ecm.f,
                                        .outlines = {cell.cortex.x}};
    write_file(argv[1], draw::to_svg(picture));
  }
  return grown.record.length > 25.0 && grown.record.length < 30.0 ? 0 : 1;
}
