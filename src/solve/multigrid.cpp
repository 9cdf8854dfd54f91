#include "solve/multigrid.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate {

namespace {

constexpr double least_reduction = 2e-5; // of a residual in one pass in single precision
constexpr double margin = 0.8;           // a pass aims at this much of the goal
constexpr int most_idle = 3;             // passes that do not halve the residual before giving up

} // namespace

SolveReport Multigrid::solve(const DragSystem& A, std::span<Vec2> v) {
  SolveReport report;
  const double F2 = ordered_sum(A.size(), 0.0, [&A](std::size_t i) { return A.F[i].squaredNorm(); });
  if (F2 == 0.0) { // nothing moves
    std::fill(v.begin(), v.end(), Vec2::Zero());
    report.converged = true;
    return report;
  }
  const double F = std::sqrt(F2);
  const double goal = m_tolerance * F;
  double r = residual(A, v);
  if (r > goal) prepare(A);
  int idle = 0;
  while (r > goal && report.iterations < m_max_iterations && idle < most_idle) {
    correct(std::max(margin * goal / r, least_reduction), v, report);
    const double before = r;
    r = residual(A, v);
    if (!(r < 0.5 * before)) ++idle;
  }
  report.residual = r / F;
  report.converged = r <= goal;
  return report;
}

double Multigrid::residual(const DragSystem& A, std::span<const Vec2> v) {
  m_residual.resize(A.size());
  matrigrate::residual(A, A.F, v, m_residual, m_fields);
  return std::sqrt(ordered_sum(A.size(), 0.0, [this](std::size_t i) { return m_residual[i].squaredNorm(); }));
}

void Multigrid::prepare(const DragSystem& A) {
  const std::size_t n = A.pairs.size();
  m_elimination.factorise(A);
  m_pairs = &A.pairs;
  m_coarse.take_links(A, m_elimination);
  if (m_x.size() != n)
    for (Field* field : {&m_diagonal, &m_smoother, &m_x, &m_r, &m_z, &m_p, &m_q}) field->resize(n);
  const std::span<const double> D = m_elimination.diagonal();
  const std::span<const double> bound = m_elimination.bound();
  parallel_for(n, [&](std::size_t i) {
    m_diagonal.x()[i] = static_cast<float>(D[i]);
    m_smoother.x()[i] = m_smoother.y()[i] = static_cast<float>(1.0 / bound[i]);
  });
}

/// Adds to v a correction that takes the residual down to `reduction` of itself, up to rounding.
void Multigrid::correct(double reduction, std::span<Vec2> v, SolveReport& report) {
  const std::size_t n = m_smoother.size();
  m_correction = m_residual;
  m_elimination.reduce(m_correction);
  double scale = 0.0;
  for (std::size_t i = 0; i < n; ++i) scale = std::max(scale, m_correction[i].lpNorm<Eigen::Infinity>());
  m_x.set_zero();
  if (scale > 0.0) {
    parallel_for(n, [&](std::size_t i) {
      m_r.x()[i] = static_cast<float>(m_correction[i].x() / scale);
      m_r.y()[i] = static_cast<float>(m_correction[i].y() / scale);
    });
    const double goal = reduction * reduction * ordered_sum(m_residual.size(), 0.0, [&](std::size_t i) {
                          return (m_residual[i] / scale).squaredNorm();
                        });
    double r_z = 0.0;
    while (dot(m_r, m_r) > goal && report.iterations < m_max_iterations) {
      precondition();
      const double r_z_old = r_z;
      r_z = dot(m_r, m_z);
      if (r_z_old == 0.0)
        m_p = m_z;
      else
        extend(m_z, static_cast<float>(r_z / r_z_old), m_p);
      multiply(m_p, m_q);
      const double alpha = r_z / dot(m_p, m_q);
      if (!(alpha > 0.0) || !std::isfinite(alpha)) break; // beyond what single precision resolves
      add_multiple(static_cast<float>(alpha), m_p, m_x);
      add_multiple(static_cast<float>(-alpha), m_q, m_r);
      ++report.iterations;
    }
  }
  parallel_for(n, [&](std::size_t i) { m_correction[i] = scale * Vec2(m_x.x()[i], m_x.y()[i]); });
  m_elimination.recover(m_residual, m_correction);
  parallel_for(v.size(), [&](std::size_t i) { v[i] += m_correction[i]; });
}

/// y = S x.
void Multigrid::multiply(const Field& x, Field& y) {
  m_pairs->multiply(m_diagonal, x, y);
  m_elimination.add_product(x, y);
}

/// z = M^-1 r: smoothed before and after the correction on the grids. Uses q.
void Multigrid::precondition() {
  assign_product(m_smoother, m_r, m_z);
  multiply(m_z, m_q);
  extend(m_r, -1.0F, m_q);
  m_coarse.add_correction(m_q, m_z);
  multiply(m_z, m_q);
  extend(m_r, -1.0F, m_q);
  add_product(m_smoother, m_q, m_z);
}

} // namespace matrigrate
