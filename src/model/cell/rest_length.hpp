#pragma once

#include "parameters/parameters.hpp"
#include "state/cortex.hpp"

#include <cstdint>
#include <span>

/// Memory of the cortex: stretched segments do not spring out again once they have shortened (Heck et al. 2020, section
/// "Protrusion retraction"). Test: tests/unit/cell/cell_test.cpp
namespace matrigrate {

/// Rest length after a step: l where l_0,init <= l < l_0, else l_0 [um].
inline double ratcheted(double l0, double l, double l0_init) { return l0_init <= l && l < l0 ? l : l0; }

/// Ratchets the rest lengths of all segments but the soft ones.
/// @param soft  1 for the segments of growing and maturing protrusions
void ratchet_rest_lengths(CortexState& c, const CellParameters& p, std::span<const std::uint8_t> soft);

} // namespace matrigrate
