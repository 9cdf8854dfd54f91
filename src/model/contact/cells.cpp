#include "contact/cells.hpp"

#include "contact/proximity.hpp"
#include "state/dof.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace matrigrate {

namespace {

/// The box around a cortex, wider by half the reach on each side.
struct Bounds {
  Vec2 low, high;

  Bounds(const CortexState& c, double reach) : low(c.x.front()), high(c.x.front()) {
    for (const Vec2& x : c.x) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    low.array() -= 0.5 * reach;
    high.array() += 0.5 * reach;
  }
  bool meets(const Bounds& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// Pairs of cells whose bounds meet, each in both orders, ascending. Cells lie in square bins as wide as the largest
/// one, so those that meet lie in bins that touch.
std::vector<Pair> close_pairs(std::span<const Cell> cells, double reach) {
  std::vector<Bounds> bounds;
  double width = 0.0;
  for (const Cell& cell : cells) {
    bounds.emplace_back(cell.cortex, reach);
    width = std::max(width, (bounds.back().high - bounds.back().low).maxCoeff());
  }
  const auto bin = [&](std::uint32_t k) {
    const Vec2 at = (0.5 * (bounds[k].low + bounds[k].high) / width).array().floor();
    return std::pair(static_cast<long>(at.x()), static_cast<long>(at.y()));
  };
  std::map<std::pair<long, long>, std::vector<std::uint32_t>> bins;
  for (std::uint32_t k = 0; k < cells.size(); ++k) bins[bin(k)].push_back(k);
  std::vector<Pair> pairs;
  for (std::uint32_t k = 0; k < cells.size(); ++k) {
    const auto [column, row] = bin(k);
    for (long dx = -1; dx <= 1; ++dx)
      for (long dy = -1; dy <= 1; ++dy)
        if (const auto found = bins.find({column + dx, row + dy}); found != bins.end())
          for (const std::uint32_t other : found->second)
            if (other != k && bounds[k].meets(bounds[other])) pairs.emplace_back(k, other);
  }
  std::ranges::sort(pairs);
  return pairs;
}

/// Force of a touch over the pressure [um^2]: half of the area that a particle of the round cell stands for.
double half_area(const Parameters& p) { return 0.5 * initial_segment_length(p.cell) * p.ecm.thickness; }

/// Minus the derivative of cell_pressure() [kPa/um].
double slope(double gap, const CellContactParameters& p) {
  if (gap < p.repulsion_range) return p.repulsion / p.repulsion_range;
  if (gap >= cell_reach(p)) return 0.0;
  return (gap < p.repulsion_range + 0.5 * p.adhesion_range ? 2.0 : -2.0) * p.adhesion / p.adhesion_range;
}

} // namespace

double cell_pressure(double gap, const CellContactParameters& p) {
  if (gap < p.repulsion_range) return p.repulsion * (1.0 - gap / p.repulsion_range);
  if (gap >= cell_reach(p)) return 0.0;
  return -p.adhesion * (1.0 - std::abs(2.0 * (gap - p.repulsion_range) / p.adhesion_range - 1.0));
}

double cell_reach(const CellContactParameters& p) {
  return p.adhesion > 0.0 ? p.repulsion_range + p.adhesion_range : p.repulsion_range;
}

std::vector<CellTouch> cell_touches(std::span<const Cell> cells, double reach) {
  std::vector<CellTouch> found;
  if (cells.size() < 2) return found;
  std::vector<std::optional<SegmentGrid>> grids(cells.size());
  for (const auto& [k, other] : close_pairs(cells, reach)) {
    const CortexState& c = cells[other].cortex;
    if (!grids[other]) grids[other].emplace(c, reach);
    const CortexState& own = cells[k].cortex;
    for (std::uint32_t i = 0; i < own.size(); ++i)
      if (const auto near = closest_segment(own.x[i], c, *grids[other], reach))
        found.push_back({k, i, other, near->segment, near->s, near->distance, near->normal});
  }
  return found;
}

void add_cell_contact(const State& s, std::span<const CellTouch> touches, const Parameters& p, double dt,
                      std::span<Vec2> force, DragSystem& A) {
  const CellContactParameters& law = p.contact.cells;
  const double width = half_area(p);
  std::vector<std::uint32_t> first; // nodes
  for (std::size_t k = 0; k < s.cells.size() && !touches.empty(); ++k) first.push_back(first_node(s, k));
  for (const CellTouch& t : touches) {
    const CortexState& c = s.cells[t.other].cortex;
    const std::uint32_t i = first[t.cell] + t.particle;
    const std::uint32_t a = first[t.other] + t.segment;
    const std::uint32_t b = first[t.other] + static_cast<std::uint32_t>(c.next(t.segment));
    const Vec2 F = width * cell_pressure(t.gap, law) * t.normal;
    force[i] += F;
    force[a] -= (1.0 - t.s) * F;
    force[b] -= t.s * F;
    const double stiffness = width * slope(t.gap, law);
    if (stiffness > 0.0)
      A.directed.add(dt * stiffness, {{i, t.normal}, {a, -(1.0 - t.s) * t.normal}, {b, -t.s * t.normal}});
  }
}

} // namespace matrigrate
