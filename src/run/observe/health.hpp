#pragma once

#include "base/failure.hpp"
#include "simulation/workspace.hpp"
#include "state/state.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

/// Signs that a computation goes well or badly. Read-only. Test: tests/unit/observe/frame_test.cpp
namespace matrigrate {

struct HealthRow {
  double t = 0.0; ///< [s]
  std::uint64_t step = 0;
  int iterations = 0;                 ///< of the solver in the last step
  int max_iterations = 0;             ///< of the solver in a step since the previous row
  double residual = 0.0;              ///< relative, of the last step [-]
  double largest_residual = 0.0;      ///< relative, of a step since the previous row [-]
  double area_ratio = undefined;      ///< area of the cell over A_0, of the smallest cell [-]
  double density_min = undefined;     ///< of solid particles, over rho_0 [-]
  double density_max = undefined;     ///< of solid particles, over rho_0 [-]
  std::size_t density_bounds = 0;     ///< particles at a density bound after the last step
  std::size_t orphans = 0;            ///< particles fluidized for want of support since the start
  std::size_t torn = 0;               ///< particles fluidized at a density bound since the start
  std::size_t engulfed = 0;           ///< solid particles fluidized inside a cell since the start
  std::size_t solid_inside = 0;       ///< solid particles inside a cell
  double deepest_solid = 0.0;         ///< their largest distance from the cortex [um]
  bool crosses_itself = false;        ///< whether the cortex of a cell does
  double fastest = 0.0;               ///< speed of the fastest particle of matrix or cells [um/s]
  double force_imbalance = undefined; ///< of the last step; see below [-]
};

/// Solid particles inside a cell.
struct SolidInside {
  std::size_t n = 0;
  double deepest = 0.0; ///< the largest distance of one from the cortex [um]
};
SolidInside solid_inside(const EcmState& ecm, const CortexState& c);

/// Sum of all inner forces of the last step over the sum of their magnitudes: rounding alone; NaN before the first
/// step.
double force_imbalance(const Workspace& w);

/// Why a computation must not go on, with what and where in words.
struct Alarm {
  FailureCause cause;
  std::string text;
};

/// The first alarm that is found, if any: something is not finite, a cell has turned inside out, collapsed or
/// crossed itself, solid matrix lies deep inside it, inner forces do not balance.
std::optional<Alarm> alarm(const State& s, const Parameters& p, const HealthRow& row);

/// Gathers the extremes of the steps between two rows.
struct HealthWatch {
  int max_iterations = 0;
  double largest_residual = 0.0;

  /// To be called after each step.
  void see(const StepHealth& step);

  /// The row up to now; the next row starts empty.
  HealthRow row(const State& s, const Parameters& p, const StepHealth& last);
};

} // namespace matrigrate
