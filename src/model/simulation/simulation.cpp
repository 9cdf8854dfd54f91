#include "simulation/simulation.hpp"

#include "parameters/changes.hpp"
#include "simulation/march.hpp"
#include "simulation/start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <new>
#include <utility>

namespace matrigrate {

namespace {

State without_cells(EcmState matrix) {
  State s;
  s.ecm = std::move(matrix);
  return s;
}

} // namespace

Simulation::Simulation(const Parameters& parameters) : Simulation(parameters, initial_state(parameters)) {}

Simulation::Simulation(const Parameters& parameters, State state)
    : p(in_force(parameters, state.t)), s(std::move(state)), w(s, p) {}

Simulation::Simulation(const Parameters& parameters, EcmState matrix)
    : Simulation(parameters, without_cells(std::move(matrix))) {}

void Simulation::march(double t_end, const Loads& loads, const Observer& each_step) {
  if (failure)
    throw NumericalFailure(failure->cause(), fmt::format("failed at {:.6g} s and cannot go on; make a new simulation, "
                                                         "with other parameters or a shorter step. It failed since {}",
                                                         s.t, failure->what()));
  try {
    if (march_to_changes(t_end, loads, each_step)) matrigrate::march(s, p, w, t_end, loads, each_step);
  } catch (const NumericalFailure& error) {
    failure = error;
    throw;
  } catch (const std::bad_alloc&) { // within a step, too; it has no cause of its own
    failure.emplace(FailureCause::solver, "memory ran out");
    throw;
  }
}

void Simulation::march_for(double seconds, const Loads& loads, const Observer& each_step) {
  march(s.t + seconds, loads, each_step);
}

bool Simulation::march_within(double t_end, const Observer& each_step) {
  return march_to_changes(t_end, {}, each_step) && matrigrate::march_within(s, p, w, t_end, each_step);
}

/// Goes on past all times of change before t_end.
/// @return false if the observer ended it
bool Simulation::march_to_changes(double t_end, const Loads& loads, const Observer& each_step) {
  bool goes_on = true;
  const Observer watch = [&](const State& now) { return goes_on = !each_step || each_step(now); };
  while (goes_on && !p.changes.empty() && p.changes.front().at < t_end) {
    matrigrate::march(s, p, w, p.changes.front().at, loads, watch);
    if (goes_on) hold(in_force(p, s.t));
  }
  return goes_on;
}

/// Goes on with other parameters, in a workspace as after a restart.
void Simulation::hold(Parameters now) {
  Workspace made(s, now);
  made.health = w.health;
  made.propensity = std::move(w.propensity);
  p = std::move(now);
  w = std::move(made);
}

void Simulation::change(const Parameters& after, const Loads& loads, const Observer& each_step) {
  if (auto faults = faults_of_change(p, after, ""); !faults.empty()) throw ConfigurationError(std::move(faults));
  const double dt = p.run.time_step;
  march(dt * std::ceil(s.t / dt - 1e-6), loads, each_step);
  hold(in_force(after, s.t));
}

} // namespace matrigrate
