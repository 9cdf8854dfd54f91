#pragma once

#include "base/failure.hpp"
#include "simulation/equations.hpp"

#include <functional>
#include <optional>

namespace matrigrate {

/// A simulation that goes on in pieces: the state, the parameters that hold now, and the workspace made from both.
/// Runs of the program, Python, the live page and the verification cases all march this one. A step that begins at or
/// after a time of change (parameters/changes.hpp) has the parameters that hold from then on.
/// Test: tests/physics/simulation_test.cpp, tests/apps/changes_test.cpp
struct Simulation {
  /// Called after every step; returning false ends the march.
  using Observer = std::function<bool(const State&)>;

  /// A migration from its beginning (simulation/start).
  /// @throws ConfigurationError as initial_state()
  explicit Simulation(const Parameters& parameters);
  /// From a state, say one of a checkpoint, with the parameters that hold from there on.
  Simulation(const Parameters& parameters, State state);
  /// A matrix without cells.
  Simulation(const Parameters& parameters, EcmState matrix);

  /// Advances until s.t has reached t_end [s].
  /// @param loads  forces from outside the model
  /// @throws NumericalFailure as matrigrate::march(). The step broke off, so that the state is that of no law: every
  ///         later call throws, too.
  void march(double t_end, const Loads& loads = {}, const Observer& each_step = {});
  void march_for(double seconds, const Loads& loads = {}, const Observer& each_step = {});

  /// The same as long as no step passes t_end [s] (matrigrate::march_within).
  /// @return whether no further step has room before t_end
  bool march_within(double t_end, const Observer& each_step);

  /// Goes on with other parameters: advances to the next multiple of run.time_step, where a branch of a run can begin,
  /// and takes them from there on, with their changes to come. Counts of StepHealth go on.
  /// @throws ConfigurationError naming parameters with which the state was made and which cannot change
  ///         (parameters/changes.hpp); nothing has happened then
  /// @throws NumericalFailure as matrigrate::march()
  void change(const Parameters& after, const Loads& loads = {}, const Observer& each_step = {});

  Parameters p; ///< those of the last step, or of the next at a start; only changes to come are left in them
  State s;
  Workspace w;
  std::optional<NumericalFailure> failure; ///< that ended a march

private:
  bool march_to_changes(double t_end, const Loads& loads, const Observer& each_step);
  void hold(Parameters now);
};

} // namespace matrigrate
