#include "solve/drag_system.hpp"

#include "base/parallel.hpp"

#include <algorithm>

namespace matrigrate {

namespace {

/// y -= what the terms make of x.
void subtract_products(const DragTerms<double>& terms, const NodeVectors& x, NodeVectors& y) {
  for (std::size_t m = 0; m < terms.size(); ++m) {
    Vec2 sum = Vec2::Zero();
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) sum += terms.weight[k] * x[terms.node[k]];
    sum *= -terms.c[m];
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) y.add(terms.node[k], terms.weight[k] * sum);
  }
}

void subtract_products(const DragTerms<Vec2>& terms, const NodeVectors& x, NodeVectors& y) {
  for (std::size_t m = 0; m < terms.size(); ++m) {
    double sum = 0.0;
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) sum += terms.weight[k].dot(x[terms.node[k]]);
    sum *= -terms.c[m];
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) y.add(terms.node[k], sum * terms.weight[k]);
  }
}

} // namespace

void NodeVectors::resize(std::size_t of_matrix, std::size_t of_all) {
  if (matrix.size() != of_matrix) matrix.resize(of_matrix);
  cell_dofs.resize(of_all - of_matrix);
}

void NodeVectors::add(std::size_t k, const Vec2& a) {
  if (k >= matrix.size()) {
    cell_dofs[k - matrix.size()] += a;
    return;
  }
  matrix.x()[k] += a.x();
  matrix.y()[k] += a.y();
}

void split(std::span<const Vec2> a, std::size_t matrix, NodeVectors& b) {
  b.resize(matrix, a.size());
  double *x = b.matrix.x(), *y = b.matrix.y();
  const auto take = [=](std::size_t i) {
    x[i] = a[i].x();
    y[i] = a[i].y();
  };
  parallel_for(matrix, take, light_grain);
  std::ranges::copy(a.subspan(matrix), b.cell_dofs.begin());
}

void join(const NodeVectors& a, std::span<Vec2> b) {
  const double *x = a.matrix.x(), *y = a.matrix.y();
  parallel_for(
      a.matrix.size(), [=](std::size_t i) { b[i] = Vec2(x[i], y[i]); }, light_grain);
  std::ranges::copy(a.cell_dofs, b.begin() + static_cast<std::ptrdiff_t>(a.matrix.size()));
}

void residual(const DragSystem& A, const NodeVectors& F, const NodeVectors& x, NodeVectors& r) {
  const std::size_t matrix = A.pairs.size();
  r.resize(matrix, A.size());
  A.pairs.residual(A.diagonal, F.matrix, x.matrix, r.matrix);
  for (std::size_t a = 0; a < r.cell_dofs.size(); ++a)
    r.cell_dofs[a] = F.cell_dofs[a] - A.diagonal[matrix + a] * x.cell_dofs[a];
  subtract_products(A.links, x, r);
  subtract_products(A.directed, x, r);
}

void residual(const DragSystem& A, std::span<const Vec2> F, std::span<const Vec2> x, std::span<Vec2> r,
              ResidualFields& fields) {
  split(F, A.pairs.size(), fields.b);
  split(x, A.pairs.size(), fields.x);
  residual(A, fields.b, fields.x, fields.r);
  join(fields.r, r);
}

void multiply(const DragSystem& A, std::span<const Vec2> x, std::span<Vec2> y) {
  ResidualFields fields;
  const std::vector<Vec2> zero(A.size(), Vec2::Zero());
  residual(A, zero, x, y, fields);
  parallel_for(A.size(), [&](std::size_t i) { y[i] = -y[i]; });
}

void diagonal_blocks(const DragSystem& A, std::vector<Mat2>& blocks) {
  blocks.resize(A.size());
  for (std::size_t i = 0; i < A.size(); ++i) blocks[i] = A.diagonal[i] * Mat2::Identity();
  for (std::size_t m = 0; m < A.links.size(); ++m)
    for (std::uint32_t k = A.links.first[m]; k < A.links.first[m + 1]; ++k)
      blocks[A.links.node[k]] += A.links.c[m] * A.links.weight[k] * A.links.weight[k] * Mat2::Identity();
  for (std::size_t m = 0; m < A.directed.size(); ++m)
    for (std::uint32_t k = A.directed.first[m]; k < A.directed.first[m + 1]; ++k)
      blocks[A.directed.node[k]] += A.directed.c[m] * A.directed.weight[k] * A.directed.weight[k].transpose();
}

} // namespace matrigrate
