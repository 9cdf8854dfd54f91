#include "ecm/deformation.hpp"

namespace matrigrate {

Mat2 deformation_gradient(const EcmState& ecm, const Reference& ref, std::size_t i) {
  const Adjacency& pairs = ref.pairs();
  const Vec2 u_i = ecm.displacement(i);
  Mat2 F = Mat2::Identity();
  for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
    const Vec2 u_ji = ecm.displacement(pairs.index[k]) - u_i;
    F += u_ji * ref.weighted_grad(k).transpose();
  }
  return F;
}

Mat2 deformation_rate(const EcmState& ecm, const Reference& ref, std::size_t i) {
  const Adjacency& pairs = ref.pairs();
  const Vec2 v_i = ecm.v[i];
  Mat2 rate = Mat2::Zero();
  for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
    const Vec2 v_ji = ecm.v[pairs.index[k]] - v_i;
    rate += v_ji * ref.weighted_grad(k).transpose();
  }
  return rate;
}

} // namespace matrigrate
