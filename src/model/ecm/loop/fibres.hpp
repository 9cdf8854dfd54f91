#pragma once

#include "ecm/law/fibre_table.hpp"
#include "ecm/law/fibres.hpp"
#include "ecm/reference.hpp"
#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/ecm.hpp"

#include <memory>
#include <span>
#include <utility>
#include <vector>

/// Strain-stiffening fibres of the matrix: springs between reference neighbours, Heck et al. 2020, Eqs. (3)-(5), and
/// their stress, Eq. (11) (MODEL.md, I23-I26). Test: tests/unit/ecm/loop/fibres_test.cpp
namespace matrigrate {

/// Whether a fibre joins reference neighbours with separation X: always, or in a uniaxial matrix if X is within
/// half_angle_deg of the direction, boundary included.
/// @param direction  of the fibres there [rad]
bool joined(const Vec2& X, const FibreParameters& p, double direction);
bool joined(const Vec2& X, const FibreParameters& p); ///< the same with fibres.direction_deg

/// Direction of uniaxial fibres between particles i and j: the mean of the axes at both [rad].
double fibre_direction(const EcmState& ecm, const FibreParameters& p, std::size_t i, std::size_t j);

/// Pairs of reference neighbours that are permanently joined by a fibre. Weights, Eq. (4): w_ij = (W_ij/S_i +
/// W_ij/S_j)/2, S_i the sum of W over i itself and all its neighbours [-]. Where the stiffness of fibres differs from
/// place to place, w_ij also contains the mean, over i and j, of the local stiffness over fibres.stiffness; every fibre
/// law is proportional to k_0 (I32).
class FibreNetwork {
public:
  FibreNetwork() = default; ///< no fibres

  /// @param table  of a law that a user gives; null: that of the paper
  FibreNetwork(const EcmState& ecm, const EcmParameters& p, const FibreParameters& fibres, const Reference& ref,
               std::shared_ptr<const FibreTable> table = nullptr);

  bool empty() const { return m_pairs.index.empty(); }
  FibreLaw law(const FibreParameters& p) const { return {p, m_table.get()}; }
  const Adjacency& pairs() const { return m_pairs; }
  const Vec2& X_ij(std::uint32_t k) const { return m_X_ij[k]; } ///< of entry k of pairs() [um]
  double length(std::uint32_t k) const { return m_length[k]; }  ///< |X_ij| [um]
  double weight(std::uint32_t k) const { return m_weight[k]; }  ///< w_ij [-]

private:
  Adjacency m_pairs;
  std::vector<Vec2> m_X_ij;
  std::vector<double> m_length, m_weight;
  std::shared_ptr<const FibreTable> m_table;
};

/// Adds the forces of the fibres [nN]. On particle i
///   -t_z sum_j f_i f_j w_ij T(eps_ij) |X_ij| n,   eps_ij = |x_ij|/|X_ij| - 1,
/// with n = x_ij/|x_ij|. The slope in excess of that at rest (k_0) also enters the drag, times dt, so that stiffening
/// does not reduce the stable step.
/// @param force  of all nodes   @param A  the drag system after assemble_viscosity(); rows that change are marked there
void add_fibre_forces(const EcmState& ecm, const EcmParameters& p, const FibreParameters& fibres,
                      const FibreNetwork& network, double dt, std::span<Vec2> force, DragSystem& A);

/// Energy of all fibres of the axial law over t_z [nN].
double fibre_energy(const EcmState& ecm, const FibreParameters& fibres, const FibreNetwork& network);

/// Cauchy stress of the fibres at particle i, Eq. (11): the virial 1/(2 V_i) sum_j F_ij (x) x_ij of the axial forces
/// per depth, V_i = V_0/rho_i [kPa]; 0 in the fluid.
Mat2 fibre_stress(const EcmState& ecm, const FibreParameters& fibres, const FibreNetwork& network, std::size_t i);

/// Von Mises stress of a plane state of stress, sigma_zz = 0: sqrt(xx^2 - xx yy + yy^2 + 3 xy^2) [kPa].
double plane_von_mises(const Mat2& stress);

} // namespace matrigrate
