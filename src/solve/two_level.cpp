#include "solve/two_level.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate {

void TwoLevel::precondition(std::span<const Vec2> r) {
  parallel_for(r.size(), [&](std::size_t i) { m_z[i] = r[i] / m_diagonal[i]; });
  m_patch.solve(r, m_z);
  m_coarse.add_correction(r, m_z);
}

SolveReport TwoLevel::solve(const DragSystem& A, std::span<Vec2> v) {
  const std::size_t n = A.size();
  m_r.resize(n);
  m_z.resize(n);
  m_p.resize(n);
  m_q.resize(n);
  const auto dot = [n](const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
    return ordered_sum(n, 0.0, [&](std::size_t i) { return a[i].dot(b[i]); });
  };

  SolveReport report;
  const double F2 = dot(A.F, A.F);
  if (F2 == 0.0) { // nothing moves
    std::fill(v.begin(), v.end(), Vec2::Zero());
    report.converged = true;
    return report;
  }
  const double goal = m_tolerance * m_tolerance * F2;
  multiply(A, v, m_q);
  parallel_for(n, [&](std::size_t i) { m_r[i] = A.F[i] - m_q[i]; });
  double r2 = dot(m_r, m_r);
  if (r2 > goal) {
    mean_diagonal(A, m_diagonal);
    m_patch.factorise(A, m_diagonal);
    m_coarse.locate(A);
    precondition(m_r);
    m_p = m_z;
  }
  double r_z = dot(m_r, m_z);
  while (r2 > goal && report.iterations < m_max_iterations) {
    multiply(A, m_p, m_q);
    const double alpha = r_z / dot(m_p, m_q);
    parallel_for(n, [&](std::size_t i) {
      v[i] += alpha * m_p[i];
      m_r[i] -= alpha * m_q[i];
    });
    r2 = dot(m_r, m_r);
    ++report.iterations;
    if (r2 <= goal) break;
    precondition(m_r);
    const double r_z_old = r_z;
    r_z = dot(m_r, m_z);
    const double beta = r_z / r_z_old;
    parallel_for(n, [&](std::size_t i) { m_p[i] = m_z[i] + beta * m_p[i]; });
  }
  report.residual = std::sqrt(r2 / F2);
  report.converged = r2 <= goal;
  return report;
}

} // namespace matrigrate
