#include "sph/interpolate.hpp"

#include "base/points_in.hpp"

namespace matrigrate {

namespace {

PointWeights weights_at(const EcmState& ecm, std::span<const Vec2> positions, const Kernel& kernel, const Vec2& point) {
  PointWeights w;
  const double support = kernel.support();
  double sum = 0.0;
  Box box = around(point, support);
  if (ecm.period_x > 0.0) box = unbounded_along_x(box);
  for (const std::uint32_t i : points_in(box, positions)) {
    if (ecm.f[i] <= 0.0 || ecm.ligand_at(i) <= 0.0) continue;
    const Vec2 d = nearest_image(positions[i] - point, ecm.period_x);
    if (d.squaredNorm() >= support * support) continue;
    w.index.push_back(i);
    w.weight.push_back(ecm.f[i] * ecm.ligand_at(i) * kernel.W(d.norm()));
    sum += w.weight.back();
  }
  w.support = ecm.V0 * sum;
  if (sum > 0.0)
    for (double& a : w.weight) a /= sum;
  return w;
}

} // namespace

PointWeights solid_weights(const EcmState& ecm, const Kernel& kernel, const Vec2& point) {
  return weights_at(ecm, ecm.x, kernel, point);
}

PointWeights material_weights(const EcmState& ecm, const Kernel& kernel, const Vec2& point) {
  return weights_at(ecm, ecm.X, kernel, point);
}

void spread(const PointWeights& w, const Vec2& force, std::span<Vec2> F) {
  for (std::size_t k = 0; k < w.index.size(); ++k) F[w.index[k]] += w.weight[k] * force;
}

Vec2 interpolate(const PointWeights& w, std::span<const Vec2> field) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t k = 0; k < w.index.size(); ++k) sum += w.weight[k] * field[w.index[k]];
  return sum;
}

} // namespace matrigrate
