#include "cell/actomyosin.hpp"

#include "cell/geometry.hpp"
#include "cell/spring.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace matrigrate {

double curvature_factor(double kappa, const ActomyosinParameters& p) {
  const double q = (kappa - p.curvature_optimum) / p.curvature_width;
  const volatile double two = 2.0; // q^2 by pow, as in the formula: the last bit of q*q can be another
  return std::exp(-std::pow(q, two));
}

double curvature_factor(double kappa, const ActomyosinParameters& p, const Law& law) {
  return law.changed() ? law({kappa}) : curvature_factor(kappa, p);
}

double F_am(double f_mat_i, double f_mat_j, double kappa, const ActomyosinParameters& p, const Law& curvature) {
  return std::min(f_mat_i, f_mat_j) * curvature_factor(kappa, p, curvature) * p.force;
}

void add_actomyosin(const CortexState& c, const ActomyosinParameters& p, std::span<const double> f_mat, double dt,
                    std::uint32_t first, std::span<Vec2> force, DragSystem& A, const Law& curvature_law) {
  std::vector<double> kappa(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) kappa[i] = curvature(c, i);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const std::size_t j = c.next(i);
    const double T = F_am(f_mat[i], f_mat[j], 0.5 * (kappa[i] + kappa[j]), p, curvature_law);
    if (T > 0.0) add_tension(c, i, T, dt, first, force, A);
  }
}

} // namespace matrigrate
