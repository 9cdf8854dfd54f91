#include "ecm/deformation.hpp"

namespace matrigrate {

Mat2 deformation_gradient(const EcmState& ecm, const Reference& ref, std::size_t i) {
  const Adjacency& pairs = ref.pairs();
  const Vec2 u_i = ecm.displacement(i);
  Mat2 sum = Mat2::Zero();
  for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
    const std::uint32_t j = pairs.index[k];
    sum += ecm.V0 * ecm.f[j] * (ecm.displacement(j) - u_i) * ref.grad_W(k).transpose();
  }
  return Mat2::Identity() + sum * ref.B(i);
}

Mat2 deformation_rate(const EcmState& ecm, const Reference& ref, std::size_t i) {
  const Adjacency& pairs = ref.pairs();
  Mat2 sum = Mat2::Zero();
  for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
    const std::uint32_t j = pairs.index[k];
    sum += ecm.V0 * ecm.f[j] * (ecm.v[j] - ecm.v[i]) * ref.grad_W(k).transpose();
  }
  return sum * ref.B(i);
}

} // namespace matrigrate
