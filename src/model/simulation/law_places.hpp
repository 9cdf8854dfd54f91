#pragma once

#include "parameters/laws/law.hpp"
#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <initializer_list>
#include <vector>

/// Where the laws of a cell act: what they may use besides their own arguments.
/// Test: tests/unit/simulation/law_places_test.cpp
namespace matrigrate {

/// At each particle of the cortex, with the protrusion that it belongs to. Empty if none of the laws uses any; the
/// matrix around is looked at only for those that use it.
/// @param time  now [s]   @param users  the laws that take these places
std::vector<LawPlace> law_places(const Cell& cell, const EcmState& ecm, const Parameters& p, double time,
                                 const Laws& laws, std::initializer_list<const Law*> users);

/// Those of the forces and of degradation, and those of transitions.
std::vector<LawPlace> places_of_forces(const Cell& cell, const EcmState& ecm, const Parameters& p, double time,
                                       const Laws& laws);
std::vector<LawPlace> places_of_transitions(const Cell& cell, const EcmState& ecm, const Parameters& p, double time,
                                            const Laws& laws);

/// At the centre of the cell; of the matrix around, the means along the cortex.
LawPlace place_of_centre(const Cell& cell, const Vec2& centre, const EcmState& ecm, const Parameters& p, double time,
                         const Law& user);

} // namespace matrigrate
