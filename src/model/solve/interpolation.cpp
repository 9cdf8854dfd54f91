#include "solve/interpolation.hpp"

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

/// Calls body(begin, end) for pieces of [0, n), each as a piece of work of its own.
template <class Body>
void in_pieces(std::size_t n, const Body& body) {
  constexpr std::size_t piece = 512;
  parallel_parts((n + piece - 1) / piece, [&](std::size_t p) { body(p * piece, std::min(n, (p + 1) * piece)); });
}

} // namespace

Interpolation::Interpolation(const Grid& grid, std::size_t nodes) {
  std::vector<std::vector<std::pair<std::uint32_t, float>>> of_point(grid.size()); // nodes and weights, in order
  std::map<std::vector<float>, std::uint32_t> known;
  for (std::size_t row = 0; row < nodes; row += field_lanes) {
    std::map<std::uint32_t, std::array<float, field_lanes>> weights;
    for (std::size_t i = row; i < std::min(nodes, row + field_lanes); ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        const float weight = rounded(grid.around(i).weight[k]);
        if (weight == 0.0F) continue;
        weights[grid.around(i).point[k]][i - row] = weight;
        of_point[grid.around(i).point[k]].emplace_back(static_cast<std::uint32_t>(i), weight);
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
  in_pieces(m_first_run.size() - 1, [&](std::size_t begin, std::size_t end) {
    sum_runs(m_first_run.data(), m_node.data(), m_run_weights.data(), begin, end, r, a);
  });
}

void Interpolation::interpolate(const Field& a, Field& z) const {
  in_pieces(m_weights_of.size(), [&](std::size_t begin, std::size_t end) {
    add_points(m_first_point.data(), m_point.data(), m_weights_of.data(), m_weights.data(), begin, end, a, z);
  });
}

} // namespace matrigrate
