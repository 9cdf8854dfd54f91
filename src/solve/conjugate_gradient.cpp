#include "solve/conjugate_gradient.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate {

namespace {

using Pair = Eigen::Array2d; // one number for each velocity component

/// a / b for each component, 0 where there is nothing left to do.
Pair ratio(const Pair& a, const Pair& b) {
  return {b.x() > 0.0 ? a.x() / b.x() : 0.0, b.y() > 0.0 ? a.y() / b.y() : 0.0};
}

} // namespace

SolveReport ConjugateGradient::solve(const DragSystem& A, std::span<Vec2> v) {
  const std::size_t n = A.size();
  m_r.resize(n);
  m_p.resize(n);
  m_q.resize(n);
  const Pair zero = Pair::Zero();

  multiply(A, v, m_q);
  parallel_for(n, [&](std::size_t i) {
    m_r[i] = A.F[i] - m_q[i];
    m_p[i] = m_r[i] / A.diagonal[i];
  });
  const double F2 = ordered_sum(n, 0.0, [&](std::size_t i) { return A.F[i].squaredNorm(); });
  Pair r_z = ordered_sum(n, zero, [&](std::size_t i) -> Pair { return m_r[i].array().square() / A.diagonal[i]; });
  double r2 = ordered_sum(n, 0.0, [&](std::size_t i) { return m_r[i].squaredNorm(); });

  SolveReport report;
  if (F2 == 0.0) { // nothing moves
    std::fill(v.begin(), v.end(), Vec2::Zero());
    report.converged = true;
    return report;
  }
  const double goal = m_tolerance * m_tolerance * F2;
  while (r2 > goal && report.iterations < m_max_iterations) {
    multiply(A, m_p, m_q);
    const Pair p_q = ordered_sum(n, zero, [&](std::size_t i) -> Pair { return m_p[i].array() * m_q[i].array(); });
    const Pair alpha = ratio(r_z, p_q);
    parallel_for(n, [&](std::size_t i) {
      v[i].array() += alpha * m_p[i].array();
      m_r[i].array() -= alpha * m_q[i].array();
    });
    const Pair r_z_old = r_z;
    r_z = ordered_sum(n, zero, [&](std::size_t i) -> Pair { return m_r[i].array().square() / A.diagonal[i]; });
    r2 = ordered_sum(n, 0.0, [&](std::size_t i) { return m_r[i].squaredNorm(); });
    const Pair beta = ratio(r_z, r_z_old);
    parallel_for(n, [&](std::size_t i) { m_p[i] = m_r[i].array() / A.diagonal[i] + beta * m_p[i].array(); });
    ++report.iterations;
  }
  report.residual = std::sqrt(r2 / F2);
  report.converged = r2 <= goal;
  return report;
}

} // namespace matrigrate
