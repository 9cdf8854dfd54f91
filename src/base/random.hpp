#pragma once

#include <cstdint>

/// Counter-based random numbers (Salmon et al. 2011, Philox4x32-10): a draw is a pure function of seed, purpose,
/// cell, step and entity. It depends neither on the order of draws, nor on threads, nor on restarts. Test:
/// tests/unit/base/base_test.cpp
namespace matrigrate {

/// Purpose of a draw, below 256; each has its own stream.
enum class Purpose : std::uint32_t { initiation = 1, disassembly = 2, sampling = 3, test = 99 };

/// Uniform draw in (0, 1), never 0 or 1.
/// @param seed    of the run
/// @param step    of the simulation
/// @param entity  index of the particle, number of the protrusion, ...
/// @param cell    its id, below 2^24; each has its own stream
double uniform(std::uint64_t seed, Purpose purpose, std::uint64_t step, std::uint32_t entity, std::uint32_t cell = 0);

/// Probability that an event of constant rate happens within dt: 1 - exp(-rate dt).
/// @param rate  [1/s], >= 0   @param dt  [s], >= 0
double event_probability(double rate, double dt);

} // namespace matrigrate
