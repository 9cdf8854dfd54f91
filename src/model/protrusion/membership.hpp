#pragma once

#include "parameters/parameters.hpp"
#include "state/cell.hpp"

#include <cstdint>
#include <vector>

/// Which part of the cortex belongs to a protrusion, and what its phase makes of it (Heck et al. 2020, Fig 3).
/// Test: tests/unit/protrusion/protrusion_test.cpp
namespace matrigrate {

inline constexpr int no_protrusion = -1;

/// Properties of the cortex that follow from the phases of the protrusions.
struct Membership {
  std::vector<int> of_particle;            ///< index into Cell::protrusions, or no_protrusion
  std::vector<double> f_mat;               ///< maturation of each particle along the cortex [-]
  std::vector<double> k_s;                 ///< spring stiffness of each segment [nN/um]
  std::vector<std::uint8_t> on_protrusion; ///< segments with both ends in one protrusion
  std::vector<std::uint8_t> soft;          ///< those of them that grow or mature
};

Membership membership(const Cell& cell, const Parameters& p);

} // namespace matrigrate
