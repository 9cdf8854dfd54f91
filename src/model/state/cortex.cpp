#include "state/cortex.hpp"

#include <cmath>
#include <numbers>

namespace matrigrate {

CortexState round_cortex(const CellParameters& p) {
  CortexState s;
  const auto n = static_cast<std::size_t>(p.particles);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    s.x.emplace_back(p.start_x + p.radius * std::cos(angle), p.start_y + p.radius * std::sin(angle));
  }
  s.v.assign(n, Vec2::Zero());
  s.l0.assign(n, initial_segment_length(p));
  return s;
}

CortexState round_cortex(CellParameters p, const CellStart& start) {
  p.start_x = start.x;
  p.start_y = start.y;
  return round_cortex(p);
}

double initial_segment_length(const CellParameters& p) {
  return 2.0 * p.radius * std::sin(std::numbers::pi / p.particles);
}

double initial_area(const CellParameters& p) {
  return 0.5 * p.particles * p.radius * p.radius * std::sin(2.0 * std::numbers::pi / p.particles);
}

} // namespace matrigrate
