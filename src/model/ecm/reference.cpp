#include "ecm/reference.hpp"

#include "base/parallel.hpp"
#include "sph/kernel.hpp"
#include "sph/neighbours.hpp"
#include "state/initial.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <map>
#include <utility>

namespace matrigrate {

namespace {

using Eigen2 = Eigen::SelfAdjointEigenSolver<Mat2>;

/// A of a particle inside an intact lattice; a multiple of the identity on both lattices.
Mat2 lattice_support(const EcmParameters& p) {
  const Kernel kernel(p.smoothing_length);
  Mat2 A = Mat2::Zero();
  for (const Vec2& X : lattice_patch(p, kernel.support()))
    A -= particle_area(p) * kernel.W_slope(X.norm()) * X * X.transpose();
  return A;
}

/// The moments of such a particle; wXX is a multiple of the identity on both lattices.
DegradationMoments full_moments(const EcmParameters& p) {
  const Kernel kernel(p.smoothing_length);
  DegradationMoments m;
  for (const Vec2& X : lattice_patch(p, kernel.support())) {
    if (X.squaredNorm() == 0.0) continue;
    const double w = kernel.W(X.norm()) / X.squaredNorm();
    m.w += w;
    m.wXX += w * X * X.transpose();
  }
  m.wXX = 0.5 * m.wXX.trace() * Mat2::Identity();
  return m;
}

PairSeparations separations_of(const EcmState& ecm, const Adjacency& pairs, const Kernel& kernel) {
  PairSeparations all;
  all.of_pair.reserve(pairs.pairs());
  std::map<std::pair<double, double>, std::uint32_t> known;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (const std::uint32_t j : pairs.of(i)) {
      const Vec2 X = nearest_image(ecm.X[i] - ecm.X[j], ecm.period_x);
      const auto [place, is_new] =
          known.emplace(std::pair(X.x(), X.y()), static_cast<std::uint32_t>(all.different.size()));
      all.of_pair.push_back(place->second);
      if (!is_new) continue;
      const double r = X.norm();
      all.different.push_back({X, kernel.W_slope(r) * X, kernel.W(r) / (r * r)});
    }
  return all;
}

MATRIGRATE_SIMD
bool any_differs(std::size_t begin, std::size_t end, std::span<const double> a, std::span<const double> b) {
  std::uint64_t any = 0;
  for (std::size_t i = begin; i < end; ++i) any |= a[i] == b[i] ? 0U : 1U;
  return any != 0;
}

} // namespace

Reference::Reference(const EcmState& ecm, const EcmParameters& p)
    : m_support_floor(p.support_floor), m_pairs(neighbours_within(ecm.X, 2.0 * p.smoothing_length, ecm.period_x)),
      m_separations(separations_of(ecm, m_pairs, Kernel(p.smoothing_length))), m_rows(m_pairs, m_separations) {
  m_B.resize(ecm.size());
  m_moments.resize(ecm.size());
  m_whole.resize(ecm.size());
  m_support.resize(ecm.size());
  m_intact.resize(ecm.size());
  m_B_lattice = lattice_support(p).inverse();
  m_lattice_moments = full_moments(p);
  const std::vector<double> intact(ecm.size(), 1.0);
  parallel_for(ecm.size(), [&](std::size_t i) {
    const Mat2 A = support_tensor(i, intact, ecm.V0);
    m_intact[i] = std::clamp(Eigen2(A, Eigen::EigenvaluesOnly).eigenvalues()(0), 1e-6, 1.0);
  });
  parallel_for(ecm.size(), [&](std::size_t i) { correct(i, ecm); });
  m_f_seen = ecm.f;
}

Mat2 Reference::support_tensor(std::size_t i, std::span<const double> f, double V0) const {
  Mat2 A = Mat2::Zero();
  for (std::uint32_t k = m_pairs.first[i]; k < m_pairs.first[i + 1]; ++k)
    A -= V0 * f[m_pairs.index[k]] * X_ij(k) * grad_W(k).transpose();
  return A;
}

void Reference::correct(std::size_t i, const EcmState& ecm) {
  const Eigen2 eigen(support_tensor(i, ecm.f, ecm.V0));
  m_support[i] = eigen.eigenvalues()(0) / m_intact[i];
  if (ecm.clamped[i]) {
    m_B[i] = m_B_lattice;
  } else {
    const Vec2 bounded = eigen.eigenvalues().cwiseMax(m_support_floor * m_intact[i]);
    m_B[i] = eigen.eigenvectors() * bounded.cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose();
  }
  m_moments[i] = {};
  bool intact = true;
  for (std::uint32_t k = m_pairs.first[i]; k < m_pairs.first[i + 1]; ++k) {
    const double f = ecm.f[m_pairs.index[k]];
    intact = intact && f == 1.0;
    m_moments[i].grad_W += f * grad_W(k);
    m_moments[i].w += f * W_over_r2(k);
    m_moments[i].wX += f * W_over_r2(k) * X_ij(k);
    m_moments[i].wXX += f * W_over_r2(k) * X_ij(k) * X_ij(k).transpose();
  }
  const double full = m_lattice_moments.w;
  m_whole[i] = intact && !ecm.clamped[i] && std::abs(m_moments[i].w - full) < 1e-9 * full ? 1 : 0; // none is missing
}

void Reference::update(const EcmState& ecm) {
  std::vector<std::uint32_t> touched;
  each_block_with(
      ecm.size(), [&](std::size_t begin, std::size_t end) { return any_differs(begin, end, ecm.f, m_f_seen); },
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t j = begin; j < end; ++j) {
          if (ecm.f[j] == m_f_seen[j]) continue;
          touched.insert(touched.end(), m_pairs.of(j).begin(), m_pairs.of(j).end());
          m_f_seen[j] = ecm.f[j];
        }
      });
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  constexpr std::size_t grain = 16;
  parallel_for(
      touched.size(), [&](std::size_t k) { correct(touched[k], ecm); }, grain);
}

} // namespace matrigrate
