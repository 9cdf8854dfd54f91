#pragma once

#include "ecm/reference.hpp"
#include "parameters/parameters.hpp"
#include "state/ecm.hpp"

#include <cstddef>

/// Fluidization of the matrix through f_degr (Heck et al. 2020, section "Degradation"; MODEL.md, D6).
/// Test: tests/unit/ecm/degradation_test.cpp
namespace matrigrate {

/// f_degr after dt of degradation: max(0, f - rate dt). It never recovers.
/// @param f  [-], in [0, 1]   @param rate  [1/s], >= 0   @param dt  [s], >= 0
double degraded(double f, double rate, double dt);

/// Turns the particle into fluid at once: f = 0, its stress gone, its density that of the fluid at rest.
void fluidize(EcmState& ecm, std::size_t i);

/// Fluidizes every free solid particle whose density stands at a bound: the gel around it is torn or crushed beyond
/// what its law describes, and a bound that is held for long would only feed a runaway.  @return how many were
/// fluidized
std::size_t fluidize_torn(EcmState& ecm, const EcmParameters& p);

/// Fluidizes every free solid particle whose support has fallen under orphan_support (a loose flake cannot carry a
/// stress), again and again until none is left; brings `ref` up to date.  @return how many were fluidized
std::size_t fluidize_orphans(EcmState& ecm, const EcmParameters& p, Reference& ref);

} // namespace matrigrate
