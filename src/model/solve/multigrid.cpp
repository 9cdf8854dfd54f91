#include "solve/multigrid.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace matrigrate {

namespace {

constexpr double least_reduction = 2e-5; // of a residual in one pass in single precision
constexpr double trusted = 1e-4; // down to this reduction what a pass says of its residual is true to some per cent
constexpr double margin = 0.9;   // a pass aims at this much of the goal
constexpr int max_idle = 3;      // passes that do not halve the residual before giving up

double norm(const NodeVectors& a) {
  double of_cell = 0.0;
  for (const Vec2& b : a.cell_dofs) of_cell += b.squaredNorm();
  return std::sqrt(squared_norm(a.matrix) + of_cell);
}

} // namespace

SolveReport Multigrid::solve(const DragSystem& A, const std::function<void()>& find_F, std::span<Vec2> v) {
  SolveReport report;
  double F = 0.0, r = 0.0;
  side_by_side({[&] { prepare(A); },
                [&] {
                  find_F();
                  split(A.F, A.pairs.size(), m_F);
                  F = norm(m_F);
                  split(v, A.pairs.size(), m_v);
                  r = residual(A);
                }});
  if (F == 0.0) { // nothing moves
    std::fill(v.begin(), v.end(), Vec2::Zero());
    report.converged = true;
    return report;
  }
  const double goal = m_tolerance * F;
  int idle = 0;
  while (r > goal && report.iterations < m_max_iterations && idle < max_idle) {
    const double reduction = std::max(margin * goal / r, least_reduction);
    const double left = correct(r, reduction, report);
    const double before = r;
    r = left <= reduction && reduction >= trusted ? left * r : residual(A);
    if (!(r < 0.5 * before)) ++idle;
  }
  join(m_v, v);
  report.residual = r / F;
  report.converged = std::isfinite(F) && r <= goal; // with infinite forces any residual would do
  return report;
}

double Multigrid::residual(const DragSystem& A) {
  matrigrate::residual(A, m_F, m_v, m_residual);
  return norm(m_residual);
}

void Multigrid::prepare(const DragSystem& A) {
  const std::size_t n = A.pairs.size();
  m_elimination.factorise(A);
  m_pairs = &A.pairs;
  if (m_x.size() != n)
    for (Field* field : {&m_diagonal, &m_smoother, &m_x, &m_r, &m_z, &m_p, &m_q}) field->resize(n);
  side_by_side(
      {[&] { m_coarse.take_links(A, m_elimination); }, [&] { m_elimination.diagonals(A, m_diagonal, m_smoother); }});
}

/// Adds to v a correction that takes the residual, r in all, down to `reduction` of itself, up to rounding.
/// @return what is left of it, by the recurrence of conjugate gradients
double Multigrid::correct(double r, double reduction, SolveReport& report) {
  side_by_side({[&] { m_elimination.reduce(m_residual); }, [&] { m_x.set_zero(); }});
  const double per_r = 1.0 / r; // what is solved for is of order 1, whatever the units
  double left2 = assign_scaled(per_r, m_residual.matrix, m_r);
  double r_z = 0.0;
  while (left2 > reduction * reduction && report.iterations < m_max_iterations) {
    const double r_z_old = std::exchange(r_z, precondition());
    if (r_z_old == 0.0)
      std::swap(m_p, m_z);
    else
      extend(m_z, static_cast<float>(r_z / r_z_old), m_p);
    multiply(m_p, m_q);
    const double alpha = r_z / dot(m_p, m_q);
    if (!(alpha > 0.0) || !std::isfinite(alpha)) break; // beyond what single precision resolves
    left2 = conjugate_gradient_step(static_cast<float>(alpha), m_p, m_q, m_x, m_r);
    ++report.iterations;
  }
  for (Vec2& a : m_residual.cell_dofs) a *= per_r;
  m_cell_dofs.resize(m_residual.cell_dofs.size());
  side_by_side({[&] {
                  const float* x = m_x.values().data();
                  double* v = m_v.matrix.values().data();
                  m_x.each_range([=](std::size_t begin, std::size_t end) {
                    for (std::size_t k = begin; k < end; ++k) v[k] += r * static_cast<double>(x[k]);
                  });
                },
                [&] { m_elimination.recover(m_residual.cell_dofs, m_x, m_cell_dofs); }});
  for (std::size_t a = 0; a < m_cell_dofs.size(); ++a) m_v.cell_dofs[a] += r * m_cell_dofs[a];
  return std::sqrt(left2);
}

/// y = S x.
void Multigrid::multiply(const Field& x, Field& y) {
  side_by_side({[&] { m_pairs->multiply(m_diagonal, x, y); }, [&] { m_elimination.multiply(x); }});
  m_elimination.add_product(1.0F, y);
}

/// y = r - S x.
void Multigrid::residual_after(const Field& x, Field& y) {
  side_by_side({[&] { m_pairs->residual(m_diagonal, m_r, x, y); }, [&] { m_elimination.multiply(x); }});
  m_elimination.add_product(-1.0F, y);
}

/// z = M^-1 r: smoothed before and after the correction on the grids. Uses q.   @return r . z
double Multigrid::precondition() {
  assign_product(m_smoother, m_r, m_z);
  residual_after(m_z, m_q);
  m_coarse.add_correction(m_q, m_z);
  residual_after(m_z, m_q);
  return add_product_and_dot(m_smoother, m_q, m_z, m_r);
}

} // namespace matrigrate
