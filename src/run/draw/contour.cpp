#include "draw/contour.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <unordered_map>

namespace matrigrate::draw {

namespace {

/// The lattice within a border of nodes that are below the level, by which each curve is closed.
class Bordered {
public:
  Bordered(const Lattice& lattice, double level) : lattice_(lattice), level_(level) {}

  std::size_t nx() const { return lattice_.nx + 2; }
  std::size_t ny() const { return lattice_.ny + 2; }
  bool above(std::size_t i, std::size_t j) const { return inside(i, j) && lattice_.at(i - 1, j - 1) > level_; }

  /// Where the level is passed between two neighbouring nodes of which one is above it; at the border at the node that
  /// is above.
  Vec2 crossing(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    if (!inside(i, j)) return lattice_.place(k - 1, l - 1);
    if (!inside(k, l)) return lattice_.place(i - 1, j - 1);
    const double a = lattice_.at(i - 1, j - 1);
    const double b = lattice_.at(k - 1, l - 1);
    const double share = (level_ - a) / (b - a);
    return (1.0 - share) * lattice_.place(i - 1, j - 1) + share * lattice_.place(k - 1, l - 1);
  }

private:
  bool inside(std::size_t i, std::size_t j) const { return i >= 1 && j >= 1 && i <= lattice_.nx && j <= lattice_.ny; }

  const Lattice& lattice_;
  double level_;
};

enum Side : std::size_t { bottom, right, top, left };

/// Pairs of sides between which a curve passes a square, from the first to the second with the region on its left.
/// @param corners  which corners are above the level: lower left 1, lower right 2, upper right 4, upper left 8
std::vector<std::array<Side, 2>> passes(unsigned corners) {
  switch (corners) {
  case 1:
    return {{bottom, left}};
  case 2:
    return {{right, bottom}};
  case 3:
    return {{right, left}};
  case 4:
    return {{top, right}};
  case 5:
    return {{bottom, left}, {top, right}};
  case 6:
    return {{top, bottom}};
  case 7:
    return {{top, left}};
  case 8:
    return {{left, top}};
  case 9:
    return {{bottom, top}};
  case 10:
    return {{right, bottom}, {left, top}};
  case 11:
    return {{right, top}};
  case 12:
    return {{left, right}};
  case 13:
    return {{bottom, right}};
  case 14:
    return {{left, bottom}};
  default:
    return {};
  }
}

/// Number of an edge of the lattice: those to the right of nodes are even, those above nodes odd.
std::size_t edge(std::size_t i, std::size_t j, Side side, std::size_t nx) {
  switch (side) {
  case bottom:
    return 2 * (j * nx + i);
  case right:
    return 2 * (j * nx + i + 1) + 1;
  case top:
    return 2 * ((j + 1) * nx + i);
  case left:
    break;
  }
  return 2 * (j * nx + i) + 1;
}

Vec2 place_of(std::size_t number, const Bordered& lattice) {
  const std::size_t i = number / 2 % lattice.nx();
  const std::size_t j = number / 2 / lattice.nx();
  return number % 2 == 0 ? lattice.crossing(i, j, i + 1, j) : lattice.crossing(i, j, i, j + 1);
}

/// From each edge that a curve passes to the next one.
std::unordered_map<std::size_t, std::size_t> steps(const Bordered& lattice, std::vector<std::size_t>& order) {
  std::unordered_map<std::size_t, std::size_t> next;
  for (std::size_t j = 0; j + 1 < lattice.ny(); ++j)
    for (std::size_t i = 0; i + 1 < lattice.nx(); ++i) {
      const unsigned corners = (lattice.above(i, j) ? 1U : 0U) | (lattice.above(i + 1, j) ? 2U : 0U)
                               | (lattice.above(i + 1, j + 1) ? 4U : 0U) | (lattice.above(i, j + 1) ? 8U : 0U);
      for (const auto& [from, to] : passes(corners)) {
        order.push_back(edge(i, j, from, lattice.nx()));
        next[order.back()] = edge(i, j, to, lattice.nx());
      }
    }
  return next;
}

} // namespace

std::vector<Curve> contours(const Lattice& lattice, double level) {
  if (lattice.nx < 2 || lattice.ny < 2 || lattice.value.size() != lattice.nx * lattice.ny)
    throw std::invalid_argument(
        fmt::format("a lattice of {} x {} nodes has {} values", lattice.nx, lattice.ny, lattice.value.size()));
  const Bordered bordered(lattice, level);
  std::vector<std::size_t> order;
  auto next = steps(bordered, order);
  std::vector<Curve> curves;
  for (const std::size_t first : order) {
    if (!next.contains(first)) continue; // on a curve that is there already
    Curve& curve = curves.emplace_back();
    for (std::size_t at = first; next.contains(at);) {
      curve.push_back(place_of(at, bordered));
      const std::size_t after = next.at(at);
      next.erase(at);
      at = after;
    }
  }
  return curves;
}

double enclosed(const Curve& curve) {
  double twice = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Vec2& a = curve[i];
    const Vec2& b = curve[i + 1 == curve.size() ? 0 : i + 1];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

} // namespace matrigrate::draw
