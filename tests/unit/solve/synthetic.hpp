#pragma once

// Drag systems as a step assembles them, from the solver's own folder alone: a lattice in a clamped disc, and a ring of
// nodes with protrusions in it that is coupled by springs, bending, area, viscous links, contacts and adhesions.

#include "solve/drag_system.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace matrigrate::synthetic {

constexpr double h = 2.6;       // smoothing length [um]
constexpr double reach = 2 * h; // of the kernel [um]

/// Drag of two volumes at distance r, with viscosity 1.
inline double drag(double r, double volumes) {
  const double q = r / h;
  if (q >= 2.0) return 0.0;
  const double slope = 35.0 / (4.0 * std::numbers::pi * std::pow(h, 4)) * std::pow(1.0 - 0.5 * q, 3);
  return 2.0 * volumes * slope * r * r / (r * r + 0.01 * h * h);
}

/// Calls visit(i, j) for all points of a and b closer than `within`, ordered by i, then j.
template <class Visit>
void for_close(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double within, const Visit& visit) {
  std::map<std::pair<int, int>, std::vector<std::uint32_t>> cells;
  const auto cell = [within](const Vec2& x) {
    return std::pair(static_cast<int>(std::floor(x.x() / within)), static_cast<int>(std::floor(x.y() / within)));
  };
  for (std::uint32_t j = 0; j < b.size(); ++j) cells[cell(b[j])].push_back(j);
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    std::vector<std::uint32_t> close;
    const auto [column, row] = cell(a[i]);
    for (int dc = -1; dc <= 1; ++dc)
      for (int dr = -1; dr <= 1; ++dr)
        if (const auto at = cells.find({column + dc, row + dr}); at != cells.end())
          for (const std::uint32_t j : at->second)
            if ((a[i] - b[j]).norm() < within) close.push_back(j);
    std::sort(close.begin(), close.end());
    for (const std::uint32_t j : close) visit(i, j);
  }
}

/// The system and what it points to.
struct Body {
  std::vector<Vec2> x; ///< of the matrix
  std::vector<bool> prescribed;
  double volume = 4.0; ///< of a particle per depth
  Adjacency pairs;
  DragSystem A;

  /// Lists neighbours within `skin` more than the kernel and sets all drag; no terms, random forces.
  void assemble(double skin = 1.0) {
    pairs = {};
    pairs.first.assign(x.size() + 1, 0);
    for_close(x, x, reach + skin, [this](std::uint32_t i, std::uint32_t j) {
      if (i == j) return;
      pairs.index.push_back(j);
      ++pairs.first[i + 1];
    });
    for (std::size_t i = 0; i < x.size(); ++i) pairs.first[i + 1] += pairs.first[i];
    A = {};
    A.position = x;
    A.prescribed.assign(prescribed.begin(), prescribed.end());
    std::vector<double> coupling(pairs.pairs(), 0.0);
    A.diagonal.assign(x.size(), 1.0);
    A.F.assign(x.size(), Vec2::Zero());
    std::mt19937 random(7);
    std::uniform_real_distribution<double> force(-1.0, 1.0);
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (prescribed[i]) continue;
      double sum = 0.0;
      for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
        const std::uint32_t j = pairs.index[k];
        const double G = static_cast<float>(drag((x[i] - x[j]).norm(), volume * volume));
        sum += G;
        if (!prescribed[j]) coupling[k] = G;
      }
      A.diagonal[i] = sum > 0.0 ? sum : 1.0;
      A.F[i] = Vec2(force(random), force(random)) * 0.01;
    }
    A.pairs.assign(pairs, coupling);
  }
};

/// A lattice of spacing 2 um in a disc whose particles within the support of its rim are prescribed.
inline Body disc(double radius, bool hexagonal = false) {
  Body body;
  const double row = hexagonal ? std::sqrt(3.0) : 2.0;
  if (hexagonal) body.volume = 2.0 * row;
  const int rows = static_cast<int>(radius / row);
  for (int b = -rows; b <= rows; ++b)
    for (int a = -static_cast<int>(radius); a <= static_cast<int>(radius); ++a) {
      const Vec2 x(2.0 * a + (hexagonal && b % 2 != 0 ? 1.0 : 0.0), row * b);
      if (x.norm() <= radius) body.x.push_back(x);
    }
  for (const Vec2& x : body.x) body.prescribed.push_back(x.norm() > radius - reach);
  body.assemble();
  return body;
}

/// Moves the matrix: a little everywhere, and within `inner` of the origin by a swirl of up to `angle` and at random by
/// up to `scatter`.
inline void stir(Body& body, double inner, double angle, double scatter) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shift(-1.0, 1.0);
  for (std::size_t i = 0; i < body.x.size(); ++i) {
    if (body.prescribed[i]) continue;
    Vec2& x = body.x[i];
    const double turn = angle * std::max(0.0, 1.0 - x.squaredNorm() / (inner * inner));
    if (turn > 0.0) x += scatter * Vec2(shift(random), shift(random));
    x = std::cos(turn) * x + std::sin(turn) * perpendicular(x);
    x += 0.4 * Vec2(std::sin(0.05 * x.y()), std::cos(0.07 * x.x()));
  }
  body.assemble();
}

/// The outline of a cell of radius 15 um around the origin, with thin protrusions.
inline std::vector<Vec2> outline(int protrusions) {
  std::vector<Vec2> ring;
  const int n = 235;
  for (int a = 0; a < n; ++a) {
    const double angle = 2.0 * std::numbers::pi * a / n;
    const Vec2 e(std::cos(angle), std::sin(angle));
    const Vec2 t = perpendicular(e);
    bool in_protrusion = false;
    for (int p = 0; p < protrusions; ++p) {
      const int middle = 20 + 80 * p;
      if (a < middle - 4 || a > middle + 4) continue;
      in_protrusion = true;
      if (a != middle) continue;
      for (int s = 1; s <= 14; ++s) ring.push_back((15.0 + 2.0 * s) * e - (1.5 - 0.05 * s) * t);
      for (int s = 14; s >= 1; --s) ring.push_back((15.0 + 2.0 * s) * e + (1.5 - 0.05 * s) * t);
    }
    if (!in_protrusion) ring.push_back(15.0 * e);
  }
  return ring;
}

/// Adds the nodes of a cell and all its terms.
inline void add_cell(Body& body, int protrusions) {
  DragSystem& A = body.A;
  const std::vector<Vec2> ring = outline(protrusions);
  const std::size_t n = ring.size();
  const auto first = static_cast<std::uint32_t>(body.x.size());
  const auto node = [&](std::size_t a) { return first + static_cast<std::uint32_t>(a % n); };
  A.diagonal.resize(first + n, 0.04);
  for (std::size_t a = 0; a < n; ++a) A.F.emplace_back(0.1 * std::cos(0.3 * static_cast<double>(a)), 0.05);
  for (std::size_t a = 100; a < 105; ++a) A.diagonal[first + a] = 1000.0;

  const auto outside = [&](const Vec2& x) { // no nearer than 1.9 um, and not in the outline
    double winding = 0.0;
    for (std::size_t a = 0; a < n; ++a) {
      const Vec2 from = ring[a] - x;
      const Vec2 to = ring[(a + 1) % n] - x;
      if (from.norm() < 1.9) return false;
      winding += std::atan2(cross(from, to), from.dot(to));
    }
    return std::abs(winding) < 1.0;
  };
  std::vector<Vec2> solid;
  std::vector<std::uint32_t> solid_node;
  for (std::uint32_t k = 0; k < first; ++k) {
    if (body.prescribed[k] || body.x[k].norm() > 60.0 || !outside(body.x[k])) continue;
    solid.push_back(body.x[k]);
    solid_node.push_back(k);
  }
  struct Sample {
    std::size_t a;
    double s, volume;
  };
  std::vector<Sample> samples;
  std::vector<Vec2> sample_x;
  DragTerms<Vec2>& directed = A.directed;
  for (std::size_t a = 0; a < n; ++a) {
    const Vec2 e = ring[(a + 1) % n] - ring[a];
    const Vec2 t = e.normalized();
    const Vec2 normal = -perpendicular(t);
    directed.add(3.6, {{node(a), -t}, {node(a + 1), t}});
    directed.add(0.3, {{node(a), -0.5 * normal}, {node(a + 1), normal}, {node(a + 2), -0.5 * normal}});
    const int count = static_cast<int>(std::ceil(e.norm() / 0.8));
    for (int m = 0; m < count; ++m) {
      const double s = (m + 0.5) / count;
      samples.push_back({a, s, e.norm() / count * 2.0});
      sample_x.push_back(ring[a] + s * e);
    }
  }
  std::vector<std::uint32_t> touched;
  for_close(solid, sample_x, reach, [&](std::uint32_t k, std::uint32_t m) {
    const Sample& sample = samples[m];
    A.links.add(drag((solid[k] - sample_x[m]).norm(), body.volume * sample.volume),
                {{solid_node[k], 1.0}, {node(sample.a), -(1.0 - sample.s)}, {node(sample.a + 1), -sample.s}});
    if (!touched.empty() && touched.back() == solid_node[k]) return;
    touched.push_back(solid_node[k]);
    const Vec2 normal = (solid[k] - sample_x[m]).normalized();
    directed.add(0.4, {{solid_node[k], normal},
                       {node(sample.a), -(1.0 - sample.s) * normal},
                       {node(sample.a + 1), -sample.s * normal}});
  });
  for (int adhesion = 0; adhesion < 4; ++adhesion) {
    const std::size_t a = n / 4 * static_cast<std::size_t>(adhesion) + 7;
    std::vector<std::uint32_t> around;
    for (std::uint32_t k = 0; k < solid.size(); ++k)
      if ((solid[k] - ring[a]).norm() < 6.0) around.push_back(solid_node[k]);
    const Vec2 e = ring[a].normalized();
    directed.add_entry(node(a), -e);
    for (const std::uint32_t k : around) directed.add_entry(k, e / static_cast<double>(around.size()));
    directed.close(0.8);
  }
  for (std::size_t a = 0; a < n; ++a)
    directed.add_entry(node(a), -0.4 * perpendicular((ring[(a + 1) % n] - ring[a]).normalized()));
  directed.close(1e-3);
}

/// A velocity close to the solution v: off by `share` of it, smoothly and not so smoothly.
inline std::vector<Vec2> nearby(const std::vector<Vec2>& v, double share) {
  std::vector<Vec2> guess = v;
  for (std::size_t i = 0; i < v.size(); ++i) guess[i] *= 1.0 + share * std::sin(0.37 * static_cast<double>(i));
  return guess;
}

} // namespace matrigrate::synthetic
