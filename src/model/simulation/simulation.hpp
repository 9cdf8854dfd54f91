#pragma once

#include "base/failure.hpp"
#include "simulation/equations.hpp"

#include <functional>
#include <optional>

namespace matrigrate {

/// A simulation that goes on in pieces: the state, the parameters that hold now, and the workspace made from both.
/// Runs of the program, Python, the live page and the verification cases all march this one.
/// Test: tests/physics/simulation_test.cpp
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

  /// Goes on with other parameters: advances to the next multiple of run.time_step, where a branch of a run can begin,
  /// and takes them from there on. Counts of StepHealth go on.
  /// @throws ConfigurationError naming parameters with which the state was made and which cannot change
  ///         (simulation/start.hpp); nothing has happened then
  /// @throws NumericalFailure as matrigrate::march()
  void change(const Parameters& after, const Loads& loads = {}, const Observer& each_step = {});

  Parameters p; ///< to be changed by change() alone
  State s;
  Workspace w;
  std::optional<NumericalFailure> failure; ///< that ended a march
};

} // namespace matrigrate
