#pragma once

#include "ecm/reference.hpp"
#include "parameters/parameters.hpp"
#include "state/ecm.hpp"

#include <cstddef>

/// Fluidization of the matrix through f_degr (Heck et al. 2020, section "Degradation"; MODEL.md, I6).
/// Test: tests/unit/ecm/ecm_test.cpp
namespace matrigrate {

/// f_degr after dt of degradation: max(0, f - rate dt). It never recovers.
/// @param f  [-], in [0, 1]   @param rate  [1/s], >= 0   @param dt  [s], >= 0
double degraded(double f, double rate, double dt);

/// Turns the particle into fluid at once: f = 0, zero stress, density of the fluid at rest.
void fluidize(EcmState& ecm, std::size_t i);

/// Fluidizes every free solid particle whose density is at a bound: the gel there is torn or crushed beyond the range
/// of the law, and enforcing the bound for long would cause a runaway.  @return number of fluidized particles
std::size_t fluidize_torn(EcmState& ecm, const EcmParameters& p);

/// Fluidizes every free solid particle whose support is below orphan_support (a loose flake cannot carry a stress).
/// Repeats until none is left, and updates `ref`.  @return number of fluidized particles
std::size_t fluidize_orphans(EcmState& ecm, const EcmParameters& p, Reference& ref);

/// Whether either of the two may find a particle; updates `ref`.
bool any_torn_or_orphan(const EcmState& ecm, const EcmParameters& p, Reference& ref);

} // namespace matrigrate
