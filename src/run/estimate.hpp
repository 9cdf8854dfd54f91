#pragma once

#include "ecm/bonds.hpp"
#include "parameters/parameters.hpp"
#include "simulation/step_limits.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace matrigrate::run {

/// Estimates for a run.
struct RunCost {
  double memory_bytes;
  double disk_bytes; ///< of its folder
  double wall_time;  ///< with one thread [s]
};

/// Particles of the matrix.
std::size_t particle_count(const Parameters& p);

/// As many threads as pay for so many particles of the matrix. Test: tests/unit/run/run_test.cpp
int threads_that_pay(std::size_t particles);

/// run.threads, or where it is 0 as many as pay, on idle cores.
int threads_of(const Parameters& p, std::size_t particles);

/// @param particles  particle_count(p)
RunCost run_cost(const Parameters& p, std::size_t particles);

/// What follows from the parameters before anything is computed.
struct Derived {
  double K;                ///< bulk modulus [kPa]
  double G;                ///< shear modulus [kPa]
  double shear_time;       ///< mu/G [s]
  double compression_time; ///< mu/(K + 4G/3) [s]
  std::size_t free_particles;
  std::size_t clamped_particles;
  std::size_t fluid_particles; ///< of the free ones, fluid from the start
  double neighbours;           ///< within the kernel's support, itself not counted
  double segment_length;       ///< of the round cell's cortex [um]
  double protrusion_width;     ///< cortex that a protrusion takes, of the round cell [um]
  double first_wait;           ///< mean time to the first protrusion, from all of the cortex [s]
  double wait;                 ///< mean time between protrusions of a polarized cell without any [s]
  double longest_step;         ///< that the run takes [s]
  double steps;                ///< of that length
  StepLimits limits;
  FibreBonds bonds; ///< of a particle, that carry fibres
  RunCost cost;

  std::size_t particles() const { return free_particles + clamped_particles; }
};

Derived derived(const Parameters& p);

/// The mean axis of the fibres, in [0, 180) degrees: that of the field of directions over the particles, where there is
/// one, else that of the bonds; none if there is no preferred axis.
std::optional<double> mean_fibre_direction(const Parameters& p, const Derived& d);

/// Step and wall time of the adaptive integrator.
struct Quicker {
  double time_step; ///< [s]
  double wall_time; ///< estimate [s]
};

/// @return nothing if the adaptive integrator is chosen already, or allows no longer step
std::optional<Quicker> with_longer_steps(const Parameters& p, const Derived& d);

/// What the reference steps cost, in one sentence: "takes the reference steps of 0.4 s throughout, about 3 min on one
/// thread; run.integrator = "adaptive" would take about 20 s". Test: tests/apps/verbs_test.cpp
/// @return empty unless the adaptive integrator saves ten seconds and half of the time
std::string cost_of_reference_steps(const Parameters& p);

/// The intervals of rows and frames that are no multiples of the time step, a sentence each: rows and frames come at
/// the ends of steps, so that they are unevenly spaced then. Test: tests/apps/exchange_test.cpp
std::vector<std::string> uneven_outputs(const Parameters& p);

/// Whether laws.initiation_bias is 0 along the whole cortex of each cell at the start, so that protrusions begin as
/// without a bias: a sentence; empty if it is not. Test: tests/apps/laws_test.cpp
std::string fault_of_bias(const Parameters& p);

/// That another model wrote a scenario, a sentence; empty if none did.
std::string note_of_scenario(const Parameters& p);

/// That fluid drags the body more than protrusions, a sentence; empty if it does not.
std::string note_of_drag(const Parameters& p);

/// What the estimate of the wall time rests on.
std::string wall_time_basis();

/// Warnings of what will go wrong or mislead, a sentence or two each.
std::vector<std::string> warnings(const Parameters& p, const Derived& d);

} // namespace matrigrate::run
