#include "solve/conjugate_gradient.hpp"

#include "base/parallel.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace matrigrate {

SolveReport ConjugateGradient::solve(const DragSystem& A, const std::function<void()>& find_F, std::span<Vec2> v) {
  find_F();
  const std::size_t n = A.size();
  m_r.resize(n);
  m_z.resize(n);
  m_p.resize(n);
  m_q.resize(n);
  diagonal_blocks(A, m_inverse);
  parallel_for(n, [&](std::size_t i) { m_inverse[i] = m_inverse[i].inverse().eval(); });
  const auto norm2 = [n](const std::vector<Vec2>& a) {
    return ordered_sum(n, 0.0, [&](std::size_t i) { return a[i].squaredNorm(); });
  };
  const auto dot = [n](const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
    return ordered_sum(n, 0.0, [&](std::size_t i) { return a[i].dot(b[i]); });
  };

  SolveReport report;
  const double F2 = norm2(A.F);
  if (F2 == 0.0) { // nothing moves
    std::fill(v.begin(), v.end(), Vec2::Zero());
    report.converged = true;
    return report;
  }
  multiply(A, v, m_q);
  parallel_for(n, [&](std::size_t i) {
    m_r[i] = A.F[i] - m_q[i];
    m_z[i] = m_inverse[i] * m_r[i];
    m_p[i] = m_z[i];
  });
  double r_z = dot(m_r, m_z);
  double r2 = norm2(m_r);
  const double goal = m_tolerance * m_tolerance * F2;
  while (r2 > goal && report.iterations < m_max_iterations) {
    multiply(A, m_p, m_q);
    const double alpha = r_z / dot(m_p, m_q);
    parallel_for(n, [&](std::size_t i) {
      v[i] += alpha * m_p[i];
      m_r[i] -= alpha * m_q[i];
      m_z[i] = m_inverse[i] * m_r[i];
    });
    const double r_z_old = r_z;
    r_z = dot(m_r, m_z);
    r2 = norm2(m_r);
    const double beta = r_z / r_z_old;
    parallel_for(n, [&](std::size_t i) { m_p[i] = m_z[i] + beta * m_p[i]; });
    ++report.iterations;
  }
  report.residual = std::sqrt(r2 / F2);
  report.converged = std::isfinite(F2) && r2 <= goal; // with infinite forces any residual would do
  return report;
}

} // namespace matrigrate
