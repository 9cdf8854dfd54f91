#pragma once

#include "base/vector.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace matrigrate {

/// The matrix at one time: all that is needed to go on. One entry a particle; the order never changes.
struct EcmState {
  double V0 = 0.0;       ///< area of a particle in the reference configuration [um^2]
  double period_x = 0.0; ///< the matrix repeats with this period along x [um]; 0: it does not

  std::vector<Vec2> X;               ///< reference positions [um]
  std::vector<Vec2> x;               ///< positions [um]; never wrapped where the matrix is periodic
  std::vector<Vec2> v;               ///< velocities of the last step [um/s]; of clamped particles: as prescribed
  std::vector<double> rho;           ///< density over rho_0 [-]
  std::vector<Mat2> S;               ///< deviatoric Cauchy stress, in-plane part [kPa]; S_zz = -(S_xx + S_yy)
  std::vector<double> f;             ///< f_degr: 1 intact solid, 0 fluid [-]
  std::vector<double> attractant;    ///< concentration of chemoattractant, >= 0; empty: there is none [-]
  std::vector<std::uint8_t> clamped; ///< 1: moves as prescribed (rim, grips, walls)

  // What varies from place to place, for good; empty where it does not.
  std::vector<double> E_ratio;           ///< Young's modulus over ecm.youngs_modulus, > 0; empty: 1 everywhere [-]
  std::vector<double> fibre_direction;   ///< of uniaxial fibres; empty: fibres.direction_deg everywhere [rad]
  std::vector<double> fibre_ratio;       ///< stiffness of fibres over fibres.stiffness, >= 0; empty: 1 everywhere [-]
  std::vector<double> ligand;            ///< share of the usual ligand on solid, >= 0; empty: 1 everywhere [-]
  std::vector<double> attractant_source; ///< release of attractant; empty: none [1/s]
  std::vector<std::uint8_t> obstacle;    ///< 1: in a rigid obstacle, clamped and never degraded; empty: there is none

  std::size_t size() const { return X.size(); }
  double stiffness(std::size_t i) const { return E_ratio.empty() ? 1.0 : E_ratio[i]; } ///< E_i over E [-]
  double ligand_at(std::size_t i) const { return ligand.empty() ? 1.0 : ligand[i]; }
  bool in_obstacle(std::size_t i) const { return !obstacle.empty() && obstacle[i] != 0; }
  Vec2 displacement(std::size_t i) const { return x[i] - X[i]; } ///< u [um]

  /// x_i - x_j, to the nearest image of j where the matrix is periodic [um].
  Vec2 separation(std::size_t i, std::size_t j) const;
};

inline Vec2 EcmState::separation(std::size_t i, std::size_t j) const { return nearest_image(x[i] - x[j], period_x); }

} // namespace matrigrate
