#include "cell/actomyosin.hpp"

#include "cell/geometry.hpp"
#include "cell/spring.hpp"

#include <algorithm>
#include <vector>

namespace matrigrate {

Strand strand(const CortexState& c, std::size_t i, std::span<const double> f_mat, std::span<const double> kappa,
              const Laws& laws, const LawPlace& place) {
  const std::size_t j = c.next(i);
  const double mean = 0.5 * (kappa[i] + kappa[j]);
  return {std::min(f_mat[i], f_mat[j]), laws.curvature_factor({mean}, place), mean,
          (c.v[i] - c.v[j]).dot((c.x[j] - c.x[i]).normalized())};
}

double F_am(const Strand& strand, const Laws& laws, const LawPlace& place) {
  return laws.contraction({strand.f_mat, strand.f_curv, strand.kappa, strand.speed}, place);
}

void add_actomyosin(const CortexState& c, std::span<const double> f_mat, std::span<const LawPlace> places, double dt,
                    std::uint32_t first, std::span<Vec2> force, DragSystem& A, const Laws& laws) {
  constexpr std::size_t speed = 3; // among the arguments of the law
  std::vector<double> kappa(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) kappa[i] = curvature(c, i);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const LawPlace place = place_at(places, i);
    const Strand now = strand(c, i, f_mat, kappa, laws, place);
    const double drag = laws.contraction.fall(speed, {now.f_mat, now.f_curv, now.kappa, now.speed}, place);
    const double T = F_am(now, laws, place) + drag * now.speed;
    if (drag > 0.0) add_dashpot(c, i, drag, first, A);
    if (T > 0.0) add_tension(c, i, T, dt, first, force, A);
  }
}

} // namespace matrigrate
