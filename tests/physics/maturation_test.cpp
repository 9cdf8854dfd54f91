#include "protrusion/maturation.hpp"

#include "protrusion/adhesion.hpp"
#include "protrusion/life_cycle.hpp"
#include "simulation/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace matrigrate;

namespace {

/// f_mat of a protrusion whose load approaches F_mat with a time constant of 20 s, in steps of dt [s].
double f_mat_of_an_element(double dt) {
  const Parameters p;
  constexpr double tau = 20.0;
  Protrusion protrusion{.centre = 0, .since = 0.0, .phase = Maturing{.direction = {1.0, 0.0}}, .record = {}};
  double F = 0.0;
  const Laws laws(p);
  for (double t = dt;; t += dt) {
    const auto& maturing = std::get<Maturing>(protrusion.phase);
    const double before = F;
    F += (maturing_f_mat(maturing.steps, laws) * p.actomyosin.force - F) * -std::expm1(-dt / tau);
    const Circumstances now{.age = t - protrusion.since, .force = F, .loading = (F - before) / dt, .support = 1.0};
    const Transition change = transition(protrusion.phase, now, p, dt, laws);
    if (!change.changes) continue;
    if (const auto* contracting = std::get_if<Contracting>(&change.next)) return contracting->f_mat;
    protrusion.phase = change.next;
    protrusion.since += change.waited;
  }
}

/// A round cell in a small gel, one protrusion of which has just adhered; its load after 5 s in steps of dt [nN].
double load_after_five_seconds(double dt) {
  Parameters p;
  p.ecm.radius = 50.0;
  p.protrusion.initiation_rate = 0.0;
  p.run.integrator = Integrator::adaptive;
  p.run.time_step = dt;
  Simulation simulation(p);
  Cell& cell = simulation.s.cells[0];
  const Vec2 d = cell.cortex.x[0].normalized();
  const Vec2 point = cell.cortex.x[0] + p.adhesion.rest_length * d;
  cell.protrusions.push_back(
      {.centre = 0, .since = 0.0, .phase = Maturing{.direction = d, .anchor = point, .held = point}, .record = {}});
  simulation.march(5.0);
  return adhesion_force(simulation.s.cells[0].cortex, simulation.s.cells[0].protrusions.at(0), p.adhesion, Laws(p));
}

} // namespace

// With steps done only when their time step ends, f_mat would be 0.75 in steps of 5 s, not 0.764.
TEST(Maturation, OfAnElementDoesNotDependOnTheStep) {
  const double tau = 20.0, first = tau * std::log(1.0 / 0.02), each = tau * std::log(0.102 / 0.002);
  const double last = first + 6.0 * each;
  const double exact = 0.1 * (7.0 + (600.0 - last) / (last / 7.0));
  EXPECT_NEAR(f_mat_of_an_element(0.05), exact, 1e-3);
  for (const double dt : {0.4, 1.0, 2.5, 5.0}) EXPECT_NEAR(f_mat_of_an_element(dt), exact, 0.004) << dt;
}

// With an adhesion that is slack in its first step, the tip would move as if free: by 0.1 um and more in a second.
TEST(Maturation, LoadsANewAdhesionAsMuchInLongSteps) {
  const double F = load_after_five_seconds(0.1);
  EXPECT_GT(F, 0.03);
  EXPECT_LT(F, 0.06);
  EXPECT_NEAR(load_after_five_seconds(1.0), F, 0.1 * F);
  EXPECT_NEAR(load_after_five_seconds(5.0), F, 0.1 * F);
}
