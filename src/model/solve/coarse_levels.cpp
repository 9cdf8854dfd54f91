#include "solve/coarse_levels.hpp"

#include "base/pack.hpp"
#include "base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace matrigrate {

namespace {

constexpr std::size_t field_lanes = Field::lanes;
constexpr std::size_t run = 4; // nodes in a row that a point reads at once

float rounded(float weight) {
  constexpr float steps = 1 << 20;
  return std::round(weight * steps) / steps;
}

/// Sums over the runs of a point, for points begin .. end - 1.
MATRIGRATE_SIMD
void sum_runs(const std::uint32_t* first, const std::uint32_t* node, const float* weight, std::size_t begin,
              std::size_t end, const Field& r, Field& a) {
  for (std::size_t q = begin; q < end; ++q) {
    HalfFloats x{}, y{};
    for (std::uint32_t k = first[q]; k < first[q + 1]; ++k) {
      HalfFloats w, r_x, r_y;
      load(weight + run * k, w);
      load(r.x() + node[k], r_x);
      load(r.y() + node[k], r_y);
      x += w * r_x;
      y += w * r_y;
    }
    a.x()[q] = (x[0] + x[1]) + (x[2] + x[3]);
    a.y()[q] = (y[0] + y[1]) + (y[2] + y[3]);
  }
}

/// Adds to the nodes of blocks begin .. end - 1 what their points make of them.
MATRIGRATE_SIMD
void add_points(const std::uint32_t* first, const std::uint32_t* point, const std::uint32_t* weights_of,
                const float* weights, std::size_t begin, std::size_t end, const Field& a, Field& z) {
  for (std::size_t b = begin; b < end; ++b) {
    const float* weight = weights + weights_of[b];
    Floats x, y;
    load(z.x() + field_lanes * b, x);
    load(z.y() + field_lanes * b, y);
    for (std::uint32_t k = first[b]; k < first[b + 1]; ++k, weight += field_lanes) {
      Floats w, a_x, a_y;
      load(weight, w);
      fill(a.x()[point[k]], a_x);
      fill(a.y()[point[k]], a_y);
      x += w * a_x;
      y += w * a_y;
    }
    store_pack(x, z.x() + field_lanes * b);
    store_pack(y, z.y() + field_lanes * b);
  }
}

} // namespace

Interpolation::Interpolation(const Grid& grid, std::size_t nodes) {
  std::vector<std::vector<std::pair<std::uint32_t, float>>> of_point(grid.size()); // nodes and weights, in order
  std::map<std::vector<float>, std::uint32_t> known;
  for (std::size_t row = 0; row < nodes; row += field_lanes) {
    std::map<std::uint32_t, std::array<float, field_lanes>> weights;
    for (std::size_t i = row; i < std::min(nodes, row + field_lanes); ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        const float weight = rounded(grid.around()[i].weight[k]);
        if (weight == 0.0F) continue;
        weights[grid.around()[i].point[k]][i - row] = weight;
        of_point[grid.around()[i].point[k]].emplace_back(static_cast<std::uint32_t>(i), weight);
      }
    std::vector<float> all;
    for (const auto& [point, of_lanes] : weights) {
      m_point.push_back(point);
      all.insert(all.end(), of_lanes.begin(), of_lanes.end());
    }
    const auto [place, is_new] = known.emplace(all, static_cast<std::uint32_t>(m_weights.size()));
    if (is_new) m_weights.insert(m_weights.end(), all.begin(), all.end());
    m_weights_of.push_back(place->second);
    m_first_point.push_back(static_cast<std::uint32_t>(m_point.size()));
  }
  for (const auto& entries : of_point) {
    for (const auto& [node, weight] : entries) {
      if (m_node.size() == m_first_run.back() || node >= m_node.back() + run) {
        m_node.push_back(node);
        m_run_weights.resize(run * m_node.size());
      }
      m_run_weights[run * (m_node.size() - 1) + node - m_node.back()] = weight;
    }
    m_first_run.push_back(static_cast<std::uint32_t>(m_node.size()));
  }
}

void Interpolation::restrict_to(const Field& r, Field& a) const {
  parallel_ranges(m_first_run.size() - 1, light_grain, [&](std::size_t begin, std::size_t end) {
    sum_runs(m_first_run.data(), m_node.data(), m_run_weights.data(), begin, end, r, a);
  });
}

void Interpolation::interpolate(const Field& a, Field& z) const {
  parallel_ranges(m_weights_of.size(), light_grain / field_lanes, [&](std::size_t begin, std::size_t end) {
    add_points(m_first_point.data(), m_point.data(), m_weights_of.data(), m_weights.data(), begin, end, a, z);
  });
}

namespace {

constexpr double least_share = 1e-3;    // grid points with less of the largest diagonal are left out
constexpr std::size_t max_direct = 100; // unknowns of the level that is solved directly
constexpr double least_diagonal = 0.6;  // of a smoother, in sums of a row's magnitudes: over 1/2 it cannot diverge

constexpr float links_share = 0.6F; // of their row sums in the diagonal of a smoother, for the same reason

using Sparse = Eigen::SparseMatrix<double>;

Sparse pair_drag_matrix(const DragSystem& A) {
  const auto n = static_cast<long>(A.pairs.size());
  Sparse matrix(n, n); // A is symmetric: column i is made of row i, whose entries come in ascending order
  for (long i = 0; i < n; ++i) {
    bool has_diagonal = false;
    const auto insert_diagonal = [&] {
      if (!std::exchange(has_diagonal, true)) matrix.insertBack(i, i) = A.diagonal[static_cast<std::size_t>(i)];
    };
    matrix.startVec(i);
    A.pairs.each_of_row(static_cast<std::size_t>(i), [&](std::size_t j, float G) {
      if (static_cast<long>(j) > i) insert_diagonal();
      matrix.insertBack(static_cast<long>(j), i) = -G;
    });
    insert_diagonal();
  }
  matrix.finalize();
  return matrix;
}

/// A symmetric matrix as diagonal, pattern and negative rest.
struct Parts {
  explicit Parts(const Sparse& A) {
    pairs.first.push_back(0);
    for (long i = 0; i < A.outerSize(); ++i) {
      double sum = 0.0;
      double on = 0.0;
      for (Sparse::InnerIterator entry(A, i); entry; ++entry) {
        sum += std::abs(entry.value());
        if (entry.row() == i) {
          on = entry.value();
          continue;
        }
        pairs.index.push_back(static_cast<std::uint32_t>(entry.row()));
        G.push_back(-entry.value());
      }
      pairs.first.push_back(static_cast<std::uint32_t>(pairs.index.size()));
      diagonal.push_back(on);
      row_sum.push_back(sum);
    }
  }
  Adjacency pairs;
  std::vector<double> G, diagonal, row_sum;
};

} // namespace

CoarseLevels::CoarseLevels(const DragSystem& reference, double spacing) {
  const std::size_t n = reference.pairs.size();
  if (n == 0 || reference.position.size() != n) return;
  m_nodes = n;
  Sparse A = pair_drag_matrix(reference);
  std::vector<Vec2> x = reference.position;
  const std::vector<std::uint8_t> all_free(n, 1);
  std::vector<std::uint8_t> free(n);
  for (std::size_t i = 0; i < n; ++i) free[i] = reference.prescribed[i] == 0 ? 1 : 0;
  Grid grid(x, spacing);
  for (;;) {
    grid.locate(x, free);
    const Sparse all = grid.P();
    const Sparse product = A * all;
    Eigen::VectorXd diagonal(all.cols());
    for (long q = 0; q < all.cols(); ++q) diagonal[q] = all.col(q).dot(product.col(q));
    const double least = least_share * diagonal.maxCoeff();
    std::vector<std::uint8_t> keep(grid.size());
    for (std::size_t q = 0; q < keep.size(); ++q) keep[q] = diagonal[static_cast<long>(q)] > least ? 1 : 0;
    grid.leave_out(keep);
    if (grid.size() == 0) return;
    grid.locate(x, free);
    const Sparse P = grid.P();
    A = Sparse(P.transpose()) * A * P;

    Level& level = m_levels.emplace_back();
    level.P = Interpolation(grid, x.size());
    level.at_links = level.at_nodes = grid.without_nodes();
    level.at_nodes.locate(reference.position, all_free);
    for (Field* field : {&level.b, &level.x, &level.r, &level.diagonal, &level.inverse_diagonal, &level.smoother})
      field->resize(grid.size());
    if (grid.size() <= max_direct) break;
    const Parts parts(A);
    level.pairs.assign(parts.pairs, parts.G);
    for (std::size_t q = 0; q < grid.size(); ++q) {
      level.diagonal.x()[q] = static_cast<float>(parts.diagonal[q]);
      const double d = std::max(parts.diagonal[q], least_diagonal * parts.row_sum[q]);
      level.inverse_diagonal.x()[q] = level.inverse_diagonal.y()[q] = static_cast<float>(1.0 / d);
    }
    x = grid.points();
    free.assign(x.size(), 1);
    grid = grid.coarser();
  }
  m_coarsest = A.cast<float>();
  m_b.resize(static_cast<long>(grid.size()), 2);
}

void CoarseLevels::take_links(const DragSystem& A, const Elimination& elimination) {
  m_fits = !m_levels.empty() && m_nodes == A.pairs.size();
  if (!m_fits) return;
  elimination.lump(A, m_links);
  m_linked.resize(m_links.size());
  for (std::size_t k = 0; k < m_links.size(); ++k) m_linked.x()[k] = m_linked.y()[k] = m_links.drag(k);
  for (Level& l : m_levels) {
    l.at_links.take(l.at_nodes, m_links.nodes());
    if (&l == &m_levels.back()) break;
    l.smoother = l.inverse_diagonal;
    l.at_links.restrict_to(m_linked, l.r);
    for (std::size_t q = 0; q < l.at_links.size(); ++q)
      if (l.r.x()[q] > 0.0F)
        l.smoother.x()[q] = l.smoother.y()[q] = 1.0F / (1.0F / l.inverse_diagonal.x()[q] + links_share * l.r.x()[q]);
  }
  m_with_links = m_coarsest;
  m_links.add_to(m_levels.back().at_links, m_with_links);
  m_factor.compute(m_with_links);
}

/// r = b - (A + P^T E P) x.
void CoarseLevels::residual(Level& level) {
  side_by_side({[&] { m_links.multiply(level.at_links, level.x); },
                [&] { level.pairs.residual(level.diagonal, level.b, level.x, level.r); }});
  m_links.subtract_from(level.at_links, level.r);
}

void CoarseLevels::add_correction(const Field& r, Field& z) {
  if (!m_fits) return;
  m_levels[0].P.restrict_to(r, m_levels[0].b);
  cycle(0);
  m_levels[0].P.interpolate(m_levels[0].x, z);
}

void CoarseLevels::cycle(std::size_t level) {
  Level& l = m_levels[level];
  if (level + 1 == m_levels.size()) {
    for (long q = 0; q < m_b.rows(); ++q) {
      m_b(q, 0) = l.b.x()[q];
      m_b(q, 1) = l.b.y()[q];
    }
    const Eigen::MatrixX2f solved = m_factor.solve(m_b);
    for (long q = 0; q < m_b.rows(); ++q) {
      l.x.x()[q] = solved(q, 0);
      l.x.y()[q] = solved(q, 1);
    }
    return;
  }
  Level& next = m_levels[level + 1];
  assign_product(l.smoother, l.b, l.x);
  residual(l);
  next.P.restrict_to(l.r, next.b);
  cycle(level + 1);
  next.P.interpolate(next.x, l.x);
  residual(l);
  add_product(l.smoother, l.r, l.x);
}

} // namespace matrigrate
