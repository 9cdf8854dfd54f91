#include "cell/geometry.hpp"

#include "base/parallel.hpp"
#include "base/points_in.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace matrigrate {

namespace {

/// Twice the signed area of the triangle a, b, c.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return (turn(a, b, c) > 0.0) != (turn(a, b, d) > 0.0) && (turn(c, d, a) > 0.0) != (turn(c, d, b) > 0.0);
}

} // namespace

double area(const CortexState& c) {
  double sum = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) sum += cross(c.x[i] - c.x[0], c.x[c.next(i)] - c.x[0]);
  return 0.5 * sum;
}

Vec2 area_gradient(const CortexState& c, std::size_t i) {
  return -0.5 * perpendicular(c.x[c.next(i)] - c.x[c.previous(i)]);
}

double perimeter(const CortexState& c) {
  double sum = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) sum += (c.x[c.next(i)] - c.x[i]).norm();
  return sum;
}

Vec2 centroid(const CortexState& c) {
  Vec2 sum = Vec2::Zero();
  double twice_area = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vec2 a = c.x[i] - c.x[0];
    const Vec2 b = c.x[c.next(i)] - c.x[0];
    sum += cross(a, b) * (a + b) / 3.0;
    twice_area += cross(a, b);
  }
  return c.x[0] + sum / twice_area;
}

Vec2 centre_of_mass(const CortexState& c) {
  return std::accumulate(c.x.begin(), c.x.end(), Vec2(0.0, 0.0)) / static_cast<double>(c.size());
}

Vec2 normal(const CortexState& c, std::size_t i) { return area_gradient(c, i).normalized(); }

std::vector<Vec2> normals(const CortexState& c) {
  std::vector<Vec2> n(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) n[i] = normal(c, i);
  return n;
}

double curvature(const CortexState& c, std::size_t i) {
  const Vec2 a = c.x[i] - c.x[c.along(i, -3)];
  const Vec2 b = c.x[c.along(i, 3)] - c.x[i];
  const double product = a.norm() * b.norm() * (a + b).norm();
  return product > 0.0 ? 2.0 * cross(a, b) / product : 0.0;
}

ClosestPoint closest_point(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 ab = b - a;
  const double l2 = ab.squaredNorm();
  const double s = l2 > 0.0 ? std::clamp((p - a).dot(ab) / l2, 0.0, 1.0) : 0.0;
  return {s, p - a - s * ab};
}

bool crosses_itself(const CortexState& c) {
  const std::size_t n = c.size();
  double longest = 0.0;
  for (std::size_t i = 0; i < n; ++i) longest = std::max(longest, (c.x[c.next(i)] - c.x[i]).squaredNorm());
  longest = std::sqrt(longest);
  const auto any_crosses = [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint8_t> near(n);
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = k % 2 == 0 ? k / 2 : n - 3 - k / 2; // long and short rows in turn
      mark_points_in(around(c.x[i], 2.0 * longest), std::span(c.x).subspan(i + 2), near.data() + i + 2); // few are near
      for (std::size_t j = next_marked(near, i + 2); j < n; j = next_marked(near, j + 1))
        if (c.next(j) != i && cross_each_other(c.x[i], c.x[c.next(i)], c.x[j], c.x[c.next(j)])) return true;
    }
    return false;
  };
  return n > 2 && parallel_any(n - 2, any_crosses, 32);
}

bool contains(const CortexState& c, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vec2& a = c.x[i];
    const Vec2& b = c.x[c.next(i)];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

std::vector<std::uint8_t> front(const CortexState& c, double polarization) {
  const Vec2 d(std::cos(polarization), std::sin(polarization));
  std::vector<std::size_t> order(c.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return c.x[i].dot(d) > c.x[j].dot(d); });
  std::vector<std::uint8_t> is_front(c.size(), 0);
  for (std::size_t k = 0; k < c.size() / 2; ++k) is_front[order[k]] = 1;
  return is_front;
}

} // namespace matrigrate
