#pragma once

#include "ecm/law/material.hpp"
#include "ecm/reference.hpp"
#include "parameters/parameters.hpp"
#include "state/ecm.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace matrigrate {

// Elastic forces of the solid over reference neighbours, and the update of its stress (Heck et al. 2020, Eq. (2),
// stress term; total-Lagrangian form and hourglass penalty: MODEL.md, I4 and I5). Test:
// tests/unit/ecm/loop/stress_test.cpp

/// Deviation of a pair from the local deformation (hourglass error), e_ij = (F_i + F_j)/2 X_ij - x_ij [um]; 0 for every
/// linear field.
Vec2 hourglass_error(const EcmState& ecm, const Reference& ref, const std::vector<Mat2>& F, std::size_t i,
                     std::uint32_t k);

/// a_hg E V_0^2, what is common to all c_ij [nN um^2].
double hourglass_scale(const EcmState& ecm, const EcmParameters& p);

/// Penalty energy of hourglass modes over t_z [nN]: sum over pairs of 1/2 c_ij |e_ij|^2 with
/// c_ij = a_hg E V_0^2 f_i f_j W_0,ij / |X_ij|^2, E the mean of the pair. The forces below contain exactly its negative
/// gradient.
double hourglass_energy(const EcmState& ecm, const EcmParameters& p, const Reference& ref, const std::vector<Mat2>& F);

/// Workspace of the sums over neighbours; structures of arrays, times f_degr where stated.
struct SolidFields {
  std::vector<double> f{};       ///< f_degr for which the fields are valid; empty: none [-]
  VectorPlanes fu{};             ///< displacement times f [um]
  TensorPlanes H{};              ///< deformation gradient less the identity, F - I [-]
  VectorPlanes hourglass{};      ///< sums of sum_hourglass() [1/um^3]
  TensorPlanes PB{};             ///< corrected first Piola-Kirchhoff stress P_i B_i, 0 in the fluid [kPa]
  std::vector<Mat2> F_partial{}; ///< deformation gradient of particles with 0 < f < 1 [-]

  void resize(std::size_t n);

  /// Deformation gradient of particle i, the identity in the fluid [-].
  Mat2 F(const EcmState& ecm, std::size_t i) const {
    if (ecm.f[i] <= 0.0) return Mat2::Identity();
    return ecm.f[i] < 1.0 ? F_partial[i] : Mat2(Mat2::Identity() + H[i]);
  }
};

/// Fields of n undeformed particles.
SolidFields undeformed(std::size_t n);

/// Updates f, fu, H and F_partial to `ecm`, only around particles whose f or displacement has changed. The result has
/// the same bits as a full recomputation.
void follow_deformation(const EcmState& ecm, const Reference& ref, SolidFields& solid);

/// Adds the elastic forces to `force` [nN]. On particle i
///   t_z V_0 sum_j V_0 f_i f_j (P_i B_i + P_j B_j) grad_0 W_ij  +  t_z sum_j c_ij e_ij,
/// where P_i contains J sigma F^-T and the stress that is conjugate to e_ij through F_i. Pair terms are
/// antisymmetric (momentum), and adjoint to deformation_rate (power balance), hence free of torque.
/// Where E varies from particle to particle, ecm/loop/stress.hpp states the terms.
/// @param solid  updated here
void add_elastic_forces(const EcmState& ecm, const EcmParameters& p, const Reference& ref, SolidFields& solid,
                        std::span<Vec2> force);

/// Particles at a density bound after an update; both should stay 0 in a healthy run.
struct DensityBounds {
  std::size_t below = 0; ///< particles held at density_min
  std::size_t above = 0; ///< particles held at density_max
};

/// Advances density and deviatoric stress of the solid over the step of dt that ended at the positions of `ecm`
/// (explicit Euler), with L = (F_new - F)/dt F^-1 over reference neighbours.
/// @param solid  in: fields at the start of the step, for the degradation of `ecm`; out: f, fu, H and F_partial at its
/// end
/// @param move   called first, for ranges of particles that make up the matrix: moves them to the end of the step
DensityBounds advance_stress(EcmState& ecm, const EcmParameters& p, const Reference& ref, SolidFields& solid, double dt,
                             const std::function<void(std::size_t begin, std::size_t end)>& move = {});

/// Advances density and deviatoric stress of one particle by dt under the velocity gradient L [1/s], explicit Euler.
void advance_stress_of(EcmState& ecm, std::size_t i, const Mat2& L, const EcmParameters& p, double dt);

// The elastic forces of a matrix whose Young's modulus varies from particle to particle (EcmState::E_ratio): those of
// ecm/loop/stress.hpp with K_i, G_i in proportion to E_i, and with the mean of E_i and E_j in the hourglass penalty of
// a pair, so that pair terms stay antisymmetric (MODEL.md, I5). Test: tests/unit/ecm/loop/graded_test.cpp

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
