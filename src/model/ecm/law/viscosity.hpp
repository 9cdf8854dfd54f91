#pragma once

#include "parameters/parameters.hpp"
#include "sph/kernel.hpp"

/// Test: tests/unit/ecm/law/law_test.cpp
namespace matrigrate {

/// Drag between two particles, viscous term of Heck et al. 2020, Eq. (2):
///   G_ij = t_z V_i V_j (mu_i + mu_j) (-x_ij . grad_i W_ij) / (|x_ij|^2 + 0.01 h^2) >= 0
/// The force on i is -G_ij (v_i - v_j), an approximation of mu lap(v) (Morris et al. 1997). It acts along the velocity
/// difference. So it conserves linear momentum exactly, but not angular momentum: it resists the rotation of a finite
/// body.
/// @param r2       |x_ij|^2 [um^2]   @param W_slope  kernel.W_slope(|x_ij|) [1/um^4], <= 0
/// @param V        volume of either particle per depth [um^2]
/// @param mu       viscosity [nN s/um^2]   @param t_z  depth [um]   @param h  smoothing length [um]
/// @return         [nN s/um]
inline double pair_drag(double r2, double W_slope, double V, double mu, double t_z, double h) {
  return t_z * V * V * 2.0 * mu * (-W_slope) * r2 / (r2 + 0.01 * h * h);
}

/// The same law for pairs of equal particles, with the constant factors precomputed:
///   G_ij = G_0 W_slope(r)/W_slope(0) r^2 / (r^2 + 0.01 h^2),   G_0 = t_z V_0^2 2 mu (-W_slope(0)).
template <class Real>
struct PairDrag {
  PairDrag(const EcmParameters& p, const Kernel& kernel, double V0)
      : per_support(static_cast<Real>(1.0 / kernel.support())), soft(static_cast<Real>(0.01 * kernel.h() * kernel.h())),
        G_0(static_cast<Real>(pair_drag(1.0, kernel.W_slope(0.0), V0, p.viscosity, p.thickness, 0.0))) {}

  /// @param r  |x_ij| [um]   @param r2  its square [um^2]   @return G_ij [nN s/um]
  [[gnu::always_inline]] Real operator()(Real r, Real r2) const {
    return G_0 * slope_shape(r, per_support) * (r2 / (r2 + soft));
  }

  Real per_support, soft, G_0;
};

} // namespace matrigrate
