#include "cell/area.hpp"

#include "cell/geometry.hpp"

#include <algorithm>

namespace matrigrate {

namespace {

double missing_area(const CortexState& c, const CellParameters& p) { return std::max(0.0, initial_area(p) - area(c)); }

/// k_A / l_0 [nN/um^3].
double stiffness(const CellParameters& p) { return p.area_stiffness / initial_segment_length(p); }

} // namespace

double area_energy(const CortexState& c, const CellParameters& p) {
  const double missing = missing_area(c, p);
  return 0.5 * stiffness(p) * missing * missing;
}

void add_area(const CortexState& c, const CellParameters& p, double dt, std::uint32_t first, std::span<Vec2> force,
              DragSystem& A) {
  const double missing = missing_area(c, p);
  if (missing <= 0.0) return;
  const double pressure = stiffness(p) * missing; // [nN/um]
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vec2 g = area_gradient(c, i);
    force[first + i] += pressure * g;
    A.directed.add_entry(first + static_cast<std::uint32_t>(i), g);
  }
  A.directed.close(dt * stiffness(p));
}

} // namespace matrigrate
