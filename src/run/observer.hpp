#pragma once

#include "state/state.hpp"

#include <optional>
#include <string_view>

namespace matrigrate::run {

/// The source of a request to stop a run after its current step.
enum class StopRequest { user, terminate };

/// Follows a run from outside: receives its events, and may request a stop.
/// The library itself prints nothing. Test: tests/unit/run/simulate_test.cpp
class RunObserver {
public:
  RunObserver() = default;
  RunObserver(const RunObserver&) = delete;
  RunObserver& operator=(const RunObserver&) = delete;
  virtual ~RunObserver() = default;

  /// A warning for the user, in a sentence.
  virtual void warn(std::string_view /*text*/) {}

  /// The run begins: its folder is about to be written.
  virtual void begin() {}

  /// The steps begin; the steps end, for whatever reason.
  /// @param t      simulated time at the first step [s]
  /// @param t_end  at the end of the run [s]
  virtual void begin_steps(double /*t*/, double /*t_end*/) {}
  virtual void end_steps() {}

  /// After each step.
  virtual void step(const State& /*s*/) {}

  /// Asked after each step. @return nothing to go on
  virtual std::optional<StopRequest> stop_request() { return std::nullopt; }
};

} // namespace matrigrate::run
