#include "cues/diffusion.hpp"

#include "base/failure.hpp"
#include "cell/geometry.hpp"
#include "sph/neighbours.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

namespace matrigrate {

namespace {

constexpr double tolerance = 1e-10; ///< relative residual; what is left is far below the error of the step
constexpr int max_iterations = 2000;

/// The pairs that both lie outside of obstacles.
Adjacency without_obstacles(const Adjacency& pairs, const EcmState& ecm) {
  Adjacency open;
  open.first.push_back(0);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (const std::uint32_t j : pairs.of(i))
      if (!ecm.in_obstacle(i) && !ecm.in_obstacle(j)) open.index.push_back(j);
    open.first.push_back(static_cast<std::uint32_t>(open.index.size()));
  }
  return open;
}

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

} // namespace

Diffusion::Diffusion(const EcmState& ecm, const EcmParameters& p)
    : m_neighbours(without_obstacles(neighbours_within(ecm.X, 1.1 * p.particle_spacing, ecm.period_x), ecm)),
      m_weight((p.lattice == Lattice::square ? 1.0 : 2.0 / 3.0) / (p.particle_spacing * p.particle_spacing)) {}

void Diffusion::multiply(const EcmState& ecm, std::span<const double> diagonal, double coupling,
                         std::span<const double> x, std::vector<double>& y) const {
  for (std::size_t i = 0; i < x.size(); ++i) {
    y[i] = 0.0;
    if (ecm.clamped[i]) continue; // its concentration is given
    y[i] = diagonal[i] * x[i];
    for (const std::uint32_t j : m_neighbours.of(i))
      if (!ecm.clamped[j]) y[i] -= coupling * x[j];
  }
}

void Diffusion::advance(EcmState& ecm, double D, std::span<const double> loss, double dt) {
  std::vector<double>& c = ecm.attractant;
  const std::size_t n = c.size();
  const double coupling = dt * D * m_weight;
  for (auto* work : {&m_diagonal, &m_r, &m_p, &m_q}) work->assign(n, 0.0);
  double size = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    if (ecm.clamped[i]) continue;
    const std::span<const std::uint32_t> neighbours = m_neighbours.of(i);
    m_diagonal[i] = 1.0 + dt * loss[i] + coupling * static_cast<double>(neighbours.size());
    double right = c[i] + dt * (ecm.attractant_source.empty() ? 0.0 : ecm.attractant_source[i]);
    double left = m_diagonal[i] * c[i];
    for (const std::uint32_t j : neighbours)
      (ecm.clamped[j] ? right : left) += (ecm.clamped[j] ? 1.0 : -1.0) * coupling * c[j];
    m_r[i] = right - left;
    size += right * right;
  }
  m_p = m_r;
  double rr = dot(m_r, m_r);
  for (int k = 0; rr > tolerance * tolerance * size; ++k) {
    if (k == max_iterations || !std::isfinite(rr))
      throw NumericalFailure(FailureCause::solver,
                             fmt::format("the attractant's diffusion was not solved in {} iterations", k));
    multiply(ecm, m_diagonal, coupling, m_p, m_q);
    const double alpha = rr / dot(m_p, m_q);
    for (std::size_t i = 0; i < n; ++i) {
      c[i] += alpha * m_p[i];
      m_r[i] -= alpha * m_q[i];
    }
    const double rr_next = dot(m_r, m_r);
    for (std::size_t i = 0; i < n; ++i) m_p[i] = m_r[i] + rr_next / rr * m_p[i];
    rr = rr_next;
  }
}

std::vector<double> attractant_loss(const State& s, const CueParameters& p) {
  std::vector<double> loss(s.ecm.size(), p.decay);
  if (p.uptake <= 0.0) return loss;
  for (const Cell& cell : s.cells) {
    Eigen::AlignedBox2d box;
    for (const Vec2& x : cell.cortex.x) box.extend(x);
    for (std::size_t i = 0; i < s.ecm.size(); ++i)
      if (box.contains(s.ecm.x[i]) && contains(cell.cortex, s.ecm.x[i])) loss[i] += p.uptake;
  }
  return loss;
}

} // namespace matrigrate
