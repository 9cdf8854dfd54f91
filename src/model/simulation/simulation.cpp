#include "simulation/simulation.hpp"

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

Simulation::Simulation(const Parameters& parameters, State state) : p(parameters), s(std::move(state)), w(s, p) {}

Simulation::Simulation(const Parameters& parameters, EcmState matrix)
    : Simulation(parameters, without_cells(std::move(matrix))) {}

void Simulation::march(double t_end, const Loads& loads, const Observer& each_step) {
  if (failure)
    throw NumericalFailure(failure->cause(), fmt::format("failed at {:.6g} s and cannot go on; make a new simulation, "
                                                         "with other parameters or a shorter step. It failed since {}",
                                                         s.t, failure->what()));
  try {
    matrigrate::march(s, p, w, t_end, loads, each_step);
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

void Simulation::change(const Parameters& after, const Loads& loads, const Observer& each_step) {
  if (auto faults = faults_of_change(p, after, ""); !faults.empty()) throw ConfigurationError(std::move(faults));
  const double dt = p.run.time_step;
  march(dt * std::ceil(s.t / dt - 1e-6), loads, each_step);
  const StepHealth counts = w.health;
  p = after;
  w = Workspace(s, p);
  w.health = counts;
}

} // namespace matrigrate
