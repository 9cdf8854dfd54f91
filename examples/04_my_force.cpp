/// What      A force of one's own: an optical trap, a spring that pulls a point of the gel towards a place outside of
///           the model. Any function of the state that adds to the forces of the particles will do.
/// Equation  Eq. (2) of Heck et al. 2020 with the load F = k (x_trap - x_bead), shared by the kernel.
/// Check     At rest the clamped rim holds what the trap pulls (third law), within 1 %.
/// Libraries Matrigrate::simulation, Matrigrate::observe (the force on the rim)
#include "ecm/law/material.hpp"
#include "observe/reaction.hpp"
#include "simulation/simulation.hpp"
#include "sph/interpolate.hpp"
#include "state/initial.hpp"

#include <fmt/format.h>

#include <vector>

using namespace matrigrate;

namespace {

constexpr double k_trap = 0.05; // [nN/um]
const Vec2 bead(6.0, 0.0);      // the point of the gel that the trap holds, at the start [um]
const Vec2 trap(7.0, 0.5);      // [um]

/// The force of the trap on the bead [nN].
Vec2 trap_force(const EcmState& ecm, const PointWeights& at_bead) {
  std::vector<Vec2> u(ecm.size());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = ecm.displacement(i);
  return k_trap * (trap - bead - interpolate(at_bead, u));
}

} // namespace

int main() {
  Parameters p;
  p.ecm.radius = 40.0;
  p.ecm.cell_hole = false;
  Simulation gel(p, disc(p));

  // Loads are called once a step, with the state at its start and the forces of all nodes: the particles of the matrix,
  // then those of the cortex of each cell, if there are any (state/dof.hpp).
  const PointWeights at_bead = solid_weights(gel.s.ecm, Kernel(p.ecm.smoothing_length), bead);
  const Loads my_force = [&](const State& now, std::span<Vec2> force) {
    spread(at_bead, trap_force(now.ecm, at_bead), force);
  };
  gel.march(12.0 * p.ecm.viscosity / moduli(p.ecm).G, my_force);

  const Vec2 pull = trap_force(gel.s.ecm, at_bead);
  const Vec2 held = clamp_force(gel.s, p, gel.w, [](const Vec2&) { return true; }); // by the whole rim
  const double off = (pull + held).norm() / pull.norm();
  fmt::print("the trap pulls with ({:.5f}, {:.5f}) nN, the rim with ({:.5f}, {:.5f}) nN: {:.2f} % off\n", pull.x(),
             pull.y(), held.x(), held.y(), 100.0 * off);
  return off < 0.01 ? 0 : 1;
}
