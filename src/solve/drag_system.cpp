#include "solve/drag_system.hpp"

#include "base/parallel.hpp"

namespace matrigrate {

namespace {

/// y -= what the terms make of x.
void subtract_products(const DragTerms<double>& terms, std::span<const Vec2> x, std::span<Vec2> y) {
  for (std::size_t m = 0; m < terms.size(); ++m) {
    Vec2 sum = Vec2::Zero();
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) sum += terms.weight[k] * x[terms.node[k]];
    sum *= terms.c[m];
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) y[terms.node[k]] -= terms.weight[k] * sum;
  }
}

void subtract_products(const DragTerms<Vec2>& terms, std::span<const Vec2> x, std::span<Vec2> y) {
  for (std::size_t m = 0; m < terms.size(); ++m) {
    double sum = 0.0;
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) sum += terms.weight[k].dot(x[terms.node[k]]);
    sum *= terms.c[m];
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) y[terms.node[k]] -= sum * terms.weight[k];
  }
}

} // namespace

void residual(const DragSystem& A, std::span<const Vec2> F, std::span<const Vec2> x, std::span<Vec2> r,
              ResidualFields& fields) {
  const std::size_t matrix = A.pairs.size();
  if (fields.x.size() != matrix)
    for (DoubleField* field : {&fields.b, &fields.x, &fields.r}) field->resize(matrix);
  parallel_for(matrix, [&](std::size_t i) {
    fields.b.x()[i] = F[i].x();
    fields.b.y()[i] = F[i].y();
    fields.x.x()[i] = x[i].x();
    fields.x.y()[i] = x[i].y();
  });
  A.pairs.residual(A.diagonal, fields.b, fields.x, fields.r);
  parallel_for(A.size(), [&](std::size_t i) {
    r[i] = i < matrix ? Vec2(fields.r.x()[i], fields.r.y()[i]) : Vec2(F[i] - A.diagonal[i] * x[i]);
  });
  subtract_products(A.links, x, r);
  subtract_products(A.directed, x, r);
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
