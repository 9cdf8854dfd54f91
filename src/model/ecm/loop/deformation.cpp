#include "ecm/loop/deformation.hpp"

namespace matrigrate {

namespace {

/// sum_j V_0 f_j (a_j - a_i) (x) B_i grad_0 W_ij of one particle.
template <class Field>
Mat2 gradient(const EcmState& ecm, const Reference& ref, std::size_t i, const Field& a) {
  const Adjacency& pairs = ref.pairs();
  Mat2 sum = Mat2::Zero();
  for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
    const std::uint32_t j = pairs.index[k];
    sum += ecm.f[j] * (a(j) - a(i)) * ref.grad_W(k).transpose();
  }
  return ecm.V0 * sum * ref.B(i);
}

} // namespace

Mat2 deformation_gradient(const EcmState& ecm, const Reference& ref, std::size_t i) {
  return Mat2::Identity() + gradient(ecm, ref, i, [&](std::size_t j) { return ecm.displacement(j); });
}

Mat2 deformation_rate(const EcmState& ecm, const Reference& ref, std::size_t i) {
  return gradient(ecm, ref, i, [&](std::size_t j) { return ecm.v[j]; });
}

} // namespace matrigrate
