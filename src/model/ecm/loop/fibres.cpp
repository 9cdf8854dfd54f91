#include "ecm/loop/fibres.hpp"

#include "base/parallel.hpp"
#include "sph/kernel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace matrigrate {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// A fibre as it stands: strain, and x_ij of its ends.
struct Stretched {
  double strain;
  Vec2 x_ij;
};

Stretched stretched(const EcmState& ecm, const FibreNetwork& network, std::size_t i, std::uint32_t k) {
  const std::uint32_t j = network.pairs().index[k];
  const Vec2 x_ij = network.X_ij(k) + ecm.displacement(i) - ecm.displacement(j);
  return {x_ij.norm() / network.length(k) - 1.0, x_ij};
}

} // namespace

bool joined(const Vec2& X, const FibreParameters& p, double direction) {
  if (p.arrangement == FibreArrangement::isotropic) return true;
  constexpr double boundary = 1e-9; // pairs on it belong
  const Vec2 along(std::cos(direction), std::sin(direction));
  return std::abs(X.dot(along)) >= (std::cos(degree * p.half_angle_deg) - boundary) * X.norm();
}

bool joined(const Vec2& X, const FibreParameters& p) { return joined(X, p, degree * p.direction_deg); }

double fibre_direction(const EcmState& ecm, const FibreParameters& p, std::size_t i, std::size_t j) {
  if (ecm.fibre_direction.empty()) return degree * p.direction_deg;
  const double a = ecm.fibre_direction[i];
  const double b = ecm.fibre_direction[j];
  if (a == b) return a;
  return 0.5 * std::atan2(std::sin(2.0 * a) + std::sin(2.0 * b), std::cos(2.0 * a) + std::cos(2.0 * b)); // of axes
}

FibreNetwork::FibreNetwork(const EcmState& ecm, const EcmParameters& p, const FibreParameters& fibres,
                           const Reference& ref, std::shared_ptr<const FibreTable> table)
    : m_table(std::move(table)) {
  const Kernel kernel(p.smoothing_length);
  const Adjacency& all = ref.pairs();
  std::vector<double> sum(ecm.size(), kernel.W(0.0));
  for (std::size_t i = 0; i < ecm.size(); ++i)
    for (std::uint32_t k = all.first[i]; k < all.first[i + 1]; ++k) sum[i] += kernel.W(ref.X_ij(k).norm());
  m_pairs.first.assign(1, 0);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    for (std::uint32_t k = all.first[i]; k < all.first[i + 1]; ++k) {
      const std::uint32_t j = all.index[k];
      const Vec2& X = ref.X_ij(k);
      if (!joined(X, fibres, fibre_direction(ecm, fibres, i, j))) continue;
      m_pairs.index.push_back(j);
      m_X_ij.push_back(X);
      m_length.push_back(X.norm());
      m_weight.push_back(0.5 * kernel.W(X.norm()) * (1.0 / sum[i] + 1.0 / sum[j]));
      if (!ecm.fibre_ratio.empty()) m_weight.back() *= 0.5 * (ecm.fibre_ratio[i] + ecm.fibre_ratio[j]);
    }
    m_pairs.first.push_back(static_cast<std::uint32_t>(m_pairs.index.size()));
  }
}

namespace {

/// Lets particle i resist changes of its distance to j with the drag g. Pairs that have drifted out of each other's
/// reach stay explicit.
void add_coupling(DragSystem& A, const EcmState& ecm, std::size_t i, std::uint32_t j, double g) {
  A.touched[i] = 1;
  const auto drag = static_cast<float>(g);
  if (ecm.clamped[j]) {
    A.F[i] += static_cast<double>(drag) * ecm.v[j];
    A.diagonal[i] += static_cast<double>(drag);
  } else if (float* G = A.pairs.find(i, j); G != nullptr) {
    const float before = *G;
    *G += drag;
    A.diagonal[i] += static_cast<double>(*G) - static_cast<double>(before); // what was added after rounding
  }
}

} // namespace

void add_fibre_forces(const EcmState& ecm, const EcmParameters& p, const FibreParameters& fibres,
                      const FibreNetwork& network, double dt, std::span<Vec2> force, DragSystem& A) {
  if (network.empty()) return;
  const FibreLaw law = network.law(fibres);
  const bool only_pulls = !law.pushes();
  parallel_for(ecm.size(), [&](std::size_t i) {
    if (ecm.f[i] <= 0.0) return;
    const Vec2 u_i = ecm.displacement(i);
    Vec2 sum = Vec2::Zero();
    for (std::uint32_t k = network.pairs().first[i]; k < network.pairs().first[i + 1]; ++k) {
      const std::uint32_t j = network.pairs().index[k];
      const Vec2 x_ij = network.X_ij(k) + u_i - ecm.displacement(j);
      const double length = network.length(k);
      if ((only_pulls && x_ij.squaredNorm() <= length * length) || ecm.f[j] <= 0.0) continue; // slack
      const Stretched s{x_ij.norm() / length - 1.0, x_ij};
      const FibreLaw::Pull pull = law.pull(s.strain);
      sum += ecm.f[j] * fibre_pull(pull.tension, s.strain, s.x_ij, network.weight(k));
      if (!pull.stiffens || ecm.clamped[i]) continue;
      add_coupling(A, ecm, i, j, dt * p.thickness * ecm.f[i] * ecm.f[j] * network.weight(k) * pull.excess);
    }
    force[i] += p.thickness * ecm.f[i] * sum;
  });
}

double fibre_energy(const EcmState& ecm, const FibreParameters& fibres, const FibreNetwork& network) {
  const FibreLaw law = network.law(fibres);
  return ordered_sum(ecm.size(), 0.0, [&](std::size_t i) {
    double sum = 0.0;
    for (std::uint32_t k = network.pairs().first[i]; k < network.pairs().first[i + 1]; ++k) {
      const double length = network.length(k);
      sum += 0.5 * ecm.f[i] * ecm.f[network.pairs().index[k]] * network.weight(k) * length * length
             * law.energy(stretched(ecm, network, i, k).strain);
    }
    return sum;
  });
}

Mat2 fibre_stress(const EcmState& ecm, const FibreParameters& fibres, const FibreNetwork& network, std::size_t i) {
  const FibreLaw law = network.law(fibres);
  Mat2 sum = Mat2::Zero();
  for (std::uint32_t k = network.pairs().first[i]; k < network.pairs().first[i + 1]; ++k) {
    const Stretched s = stretched(ecm, network, i, k);
    const double f = ecm.f[i] * ecm.f[network.pairs().index[k]];
    sum += f * network.weight(k) * law.tension(s.strain) / (1.0 + s.strain) * s.x_ij * s.x_ij.transpose();
  }
  return ecm.rho[i] / (2.0 * ecm.V0) * sum;
}

double plane_von_mises(const Mat2& stress) {
  const double xx = stress(0, 0);
  const double yy = stress(1, 1);
  const double xy = 0.5 * (stress(0, 1) + stress(1, 0));
  return std::sqrt(std::max(0.0, xx * xx - xx * yy + yy * yy + 3.0 * xy * xy));
}

} // namespace matrigrate
