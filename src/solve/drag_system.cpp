#include "solve/drag_system.hpp"

#include "base/parallel.hpp"

namespace matrigrate {

namespace {

void add_products(const DragTerms<double>& terms, std::span<const Vec2> x, std::span<Vec2> y) {
  for (std::size_t m = 0; m < terms.size(); ++m) {
    Vec2 sum = Vec2::Zero();
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) sum += terms.weight[k] * x[terms.node[k]];
    sum *= terms.c[m];
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) y[terms.node[k]] += terms.weight[k] * sum;
  }
}

void add_products(const DragTerms<Vec2>& terms, std::span<const Vec2> x, std::span<Vec2> y) {
  for (std::size_t m = 0; m < terms.size(); ++m) {
    double sum = 0.0;
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) sum += terms.weight[k].dot(x[terms.node[k]]);
    sum *= terms.c[m];
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k) y[terms.node[k]] += sum * terms.weight[k];
  }
}

} // namespace

void multiply(const DragSystem& A, std::span<const Vec2> x, std::span<Vec2> y) {
  const Adjacency& pairs = *A.pairs;
  parallel_for(A.size(), [&](std::size_t i) {
    Vec2 sum = A.diagonal[i] * x[i];
    if (i < pairs.size())
      for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) sum -= A.coupling[k] * x[pairs.index[k]];
    y[i] = sum;
  });
  add_products(A.links, x, y);
  add_products(A.directed, x, y);
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
