#pragma once

#include "ecm/loop/stress.hpp"

/// The elastic forces of a matrix whose Young's modulus varies from particle to particle (EcmState::E_ratio): those of
/// ecm/loop/stress.hpp with K_i, G_i in proportion to E_i, and with the mean of E_i and E_j in the hourglass penalty of
/// a pair, so that pair terms stay antisymmetric (MODEL.md, I5). Test: tests/unit/ecm/loop/graded_test.cpp
namespace matrigrate {

/// (E_i + E_j)/2 over ecm.youngs_modulus [-].
inline double mean_stiffness(const EcmState& ecm, std::size_t i, std::size_t j) {
  return ecm.E_ratio.empty() ? 1.0 : 0.5 * (ecm.E_ratio[i] + ecm.E_ratio[j]);
}

/// Adds the elastic forces to `force` as add_elastic_forces() does, one particle at a time [nN].
/// @param ecm    with one E_ratio a particle
/// @param solid  with the deformation of `ecm`; PB and hourglass are computed here
void add_graded_elastic_forces(const EcmState& ecm, const EcmParameters& p, const Reference& ref, SolidFields& solid,
                               std::span<Vec2> force);

} // namespace matrigrate
