/// What      A cell that was stretched in all directions relaxes to its size.
/// Equation  Eq. (1) of Heck et al. 2020 with springs, dashpots and the drag of the liquid alone. For a ring of N
///           particles, stretched by a share eps, it is (gamma + eta_c a^2) d eps/dt = -k_s a^2 eps with
///           a = 2 sin(pi/N): eps decays with the time constant (gamma + eta_c a^2)/(k_s a^2).
/// Check     The time constant, within 3 %.
/// Libraries Matrigrate::simulation
#include "cell/geometry.hpp"
#include "simulation/simulation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

using namespace matrigrate;

namespace {

/// A cell in a wide hole, in a liquid, without anything that pulls it together but its springs.
Parameters parameters() {
  Parameters p;
  p.ecm.radius = 40.0;
  p.degradation.body_distance = 10.0; // margin of the hole around the cell
  p.contact.fluid_share = 0.0;        // degraded matrix does not resist the cell, neither protrusions ...
  p.contact.body_fluid_share = 0.0;   // ... nor body
  p.actomyosin.force = 0.0;
  p.cell.bending_stiffness = 0.0;
  p.protrusion.initiation_rate = 0.0;
  p.run.time_step = 0.2;
  return p;
}

/// Share by which the ring is longer than at the start.
double stretch(const State& s, const Parameters& p) {
  return perimeter(s.cells.front().cortex) / (p.cell.particles * initial_segment_length(p.cell)) - 1.0;
}

} // namespace

int main() {
  const Parameters p = parameters();
  Simulation cell(p);
  const State& s = cell.s;
  for (Vec2& x : cell.s.cells.front().cortex.x) x *= 1.03;

  const double gamma = p.cell.liquid_drag * p.ecm.thickness;
  const double a = 2.0 * std::sin(std::numbers::pi / p.cell.particles);
  const double expected = (gamma + p.cell.dashpot * a * a) / (p.cell.spring_stiffness * a * a);

  const double before = stretch(s, p);
  fmt::print("time [s]  stretch [%]\n");
  for (int k = 0; k <= 4; ++k) {
    cell.march(0.25 * k * expected);
    fmt::print("{:8.1f}  {:.3f}\n", s.t, 100.0 * stretch(s, p));
  }

  const double measured = s.t / std::log(before / stretch(s, p));
  fmt::print("time constant: {:.2f} s, from Eq. (1): {:.2f} s\n", measured, expected);
  return std::abs(measured / expected - 1.0) < 0.03 ? 0 : 1;
}
