#pragma once

#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <vector>

/// What a cell senses of the matrix around it, and where it therefore begins protrusions (MODEL.md, I34 to I36). The
/// paper has no cue: all are off by default. Test: tests/unit/cues/sensing_test.cpp
namespace matrigrate {

/// Share of receptors that bind attractant, c/(K_d + c) [-].   @param c  concentration, >= 0   @param K_d  > 0
double occupancy(double c, double K_d);

/// What the cell feels at each particle of its cortex, as an exponent: chemotaxis times the occupancy there, haptotaxis
/// times the ligand on solid there, guidance times cos 2(angle of the particle seen from the centre - angle of the
/// fibres there). Means over the matrix within the support of the kernel. Empty if no cue is on [-].
std::vector<double> felt(const Cell& cell, const EcmState& ecm, const Parameters& p);

/// Factor of each particle on the rate of initiation: exp(felt), over its mean along the cortex, so that a cell that is
/// all front begins as many protrusions as without cues. Empty if no cue is on [-].
std::vector<double> propensity(const Cell& cell, const EcmState& ecm, const Parameters& p);

} // namespace matrigrate
