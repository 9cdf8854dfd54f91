#include "protrusion/polarization.hpp"

#include <cmath>
#include <numbers>
#include <variant>

namespace matrigrate {

std::optional<double> adhesion_direction(const Cell& cell, const Vec2& centre) {
  Vec2 sum = Vec2::Zero();
  for (const Protrusion& protrusion : cell.protrusions)
    if (const auto* contracting = std::get_if<Contracting>(&protrusion.phase))
      sum += (contracting->anchor - centre).normalized();
  if (sum.norm() < 1e-9) return std::nullopt; // no adhesions, or in opposite directions
  return std::atan2(sum.y(), sum.x());
}

double turned(double angle, double target, double dt, const Law& law, const LawPlace& place) {
  const double difference = std::remainder(target - angle, 2.0 * std::numbers::pi);
  const double share = -std::expm1(-law({std::abs(difference)}, place) * dt);
  return std::remainder(angle + share * difference, 2.0 * std::numbers::pi);
}

void polarize(Cell& cell, const Vec2& centre, double dt, const Law& law, const LawPlace& place) {
  if (!cell.polarization) return;
  if (const std::optional<double> target = adhesion_direction(cell, centre))
    cell.polarization = turned(*cell.polarization, *target, dt, law, place);
}

} // namespace matrigrate
