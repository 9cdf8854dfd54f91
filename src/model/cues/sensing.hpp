#pragma once

#include "parameters/laws/law.hpp"
#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <vector>

/// What a cell senses of the matrix around it, and where it therefore begins protrusions (MODEL.md, I34 to I36), by
/// laws.initiation_rate and laws.initiation_bias. The paper has no cue. Test: tests/unit/cues/sensing_test.cpp
namespace matrigrate {

/// Share of receptors that bind attractant, c/(K_d + c) [-].   @param c  concentration, >= 0   @param K_d  > 0
double occupancy(double c, double K_d);

/// What laws see at each particle of the cortex, but of its protrusion.
/// @param matrix  whether that around is wanted: means over the particles near it
std::vector<LawPlace> places_along(const CortexState& c, const EcmState& ecm, const Parameters& p, double time,
                                   bool matrix);

/// A law of initiation at each particle of the cortex: of its angle to the polarization as
/// seen from the centre and of its curvature; of the means over the matrix near it (0 without any) of the occupancy of
/// receptors, of ligand on solid, and of cos 2(its angle - angle of the fibres), the alignment. Before the first
/// protrusion there is no polarization: then it is the mean over all angles.   @param time  now [s]
std::vector<double> along_cortex(const Law& law, const Cell& cell, const EcmState& ecm, const Parameters& p,
                                 double time = 0.0);

/// Factor of each particle on the rate of initiation: the bias over its mean along the cortex, so that a cell that is
/// all front begins as many protrusions as without. Empty, a factor of 1, if the bias is 0 along the whole cortex
/// [-].
/// @param bias  laws.initiation_bias
std::vector<double> propensity(const Cell& cell, const EcmState& ecm, const Parameters& p, const Law& bias,
                               double time = 0.0);

} // namespace matrigrate
