/// What      A gel under a point force: how far a point beside the force has moved, against time.
/// Equation  Eq. (2) of Heck et al. 2020: viscous drag of the matrix balances its stress and the load. The gel is a
///           Kelvin-Voigt solid, so that the displacement creeps to its limit with the time constant mu/G.
/// Check     The limit is that of plane strain in a clamped disc (validation/closed_forms.hpp), within 5 %.
/// Libraries Matrigrate::simulation, Matrigrate::validation (the closed form)
#include "ecm/law/material.hpp"
#include "simulation/simulation.hpp"
#include "sph/interpolate.hpp"
#include "state/initial.hpp"
#include "validation/closed_forms.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

using namespace matrigrate;

namespace {

constexpr double pull = 0.03; // along x [nN]

/// The particle that stood closest to a point.
std::size_t closest(const EcmState& ecm, const Vec2& point) {
  std::size_t found = 0;
  for (std::size_t i = 1; i < ecm.size(); ++i)
    if ((ecm.X[i] - point).norm() < (ecm.X[found] - point).norm()) found = i;
  return found;
}

} // namespace

int main() {
  // Parameters: those of the paper's Table 1, in a small disc without a cell.
  Parameters p;
  p.ecm.radius = 50.0;
  p.ecm.cell_hole = false;
  const double G = moduli(p.ecm).G;
  const double tau = p.ecm.viscosity / G;

  Simulation gel(p, disc(p));
  const EcmState& ecm = gel.s.ecm;

  // The load: a force at the origin, shared among the particles around it by the kernel.
  const PointWeights origin = solid_weights(ecm, Kernel(p.ecm.smoothing_length), Vec2::Zero());
  const Loads load = [&](const State&, std::span<Vec2> force) { spread(origin, Vec2(pull, 0.0), force); };

  // The march, and a row of the table at each time constant.
  const std::size_t probe = closest(ecm, Vec2(14.0, 0.0));
  fmt::print("time [s]  displacement [um]\n");
  for (int k = 1; k <= 8; ++k) {
    gel.march(k * tau, load);
    fmt::print("{:8.1f}  {:.4f}\n", gel.s.t, ecm.displacement(probe).x());
  }

  // The check. The clamp begins half a spacing inside of the innermost clamped particles.
  const double rim = p.ecm.radius - 2.0 * p.ecm.smoothing_length + 0.5 * p.ecm.particle_spacing;
  const double expected = validation::clamped_disc_displacement(Vec2(pull / p.ecm.thickness, 0.0), ecm.X[probe], rim, G,
                                                                p.ecm.poissons_ratio)
                              .x();
  const double off = ecm.displacement(probe).x() / expected - 1.0;
  fmt::print("closed form: {:.4f} um; the gel is off by {:+.1f} %\n", expected, 100.0 * off);
  return std::abs(off) < 0.05 ? 0 : 1;
}
