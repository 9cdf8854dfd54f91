#include "cell/actomyosin.hpp"

#include "cell/geometry.hpp"
#include "cell/spring.hpp"

#include <algorithm>
#include <vector>

namespace matrigrate {

double F_am(double f_mat_i, double f_mat_j, double kappa, const ActomyosinParameters& p, const Law& curvature_factor) {
  return std::min(f_mat_i, f_mat_j) * curvature_factor({kappa}) * p.force;
}

void add_actomyosin(const CortexState& c, const ActomyosinParameters& p, std::span<const double> f_mat, double dt,
                    std::uint32_t first, std::span<Vec2> force, DragSystem& A, const Law& curvature_factor) {
  std::vector<double> kappa(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) kappa[i] = curvature(c, i);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const std::size_t j = c.next(i);
    const double T = F_am(f_mat[i], f_mat[j], 0.5 * (kappa[i] + kappa[j]), p, curvature_factor);
    if (T > 0.0) add_tension(c, i, T, dt, first, force, A);
  }
}

} // namespace matrigrate
