#include "ecm/bonds.hpp"

#include "ecm/loop/fibres.hpp"
#include "sph/kernel.hpp"
#include "state/initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace matrigrate {

namespace {

constexpr double same_direction = 1e-6; // [degrees]

/// Axis of X, in [0, 180) degrees.
double axis_of(const Vec2& X) {
  const double angle = std::atan2(X.y(), X.x()) * 180.0 / std::numbers::pi;
  const double folded = angle < -same_direction ? angle + 180.0 : std::max(angle, 0.0);
  return folded > 180.0 - same_direction ? 0.0 : folded;
}

/// Angle between two axes, in [0, 90] degrees.
double between(double a, double b) {
  const double difference = std::fmod(std::abs(a - b), 180.0);
  return std::min(difference, 180.0 - difference);
}

std::vector<Vec2> bonds(const EcmParameters& ecm) {
  std::vector<Vec2> all = lattice_patch(ecm, 2.0 * ecm.smoothing_length);
  const Kernel kernel(ecm.smoothing_length);
  std::erase_if(all, [&](const Vec2& X) { return X.norm() == 0.0 || kernel.W(X.norm()) <= 0.0; });
  return all;
}

/// The directions nearest to one, of which there may be dozens, as a list in words.
std::string nearest_directions(std::vector<double> directions, double to) {
  constexpr std::ptrdiff_t most = 8;
  std::ranges::stable_sort(directions, {}, [&](double d) { return between(d, to); });
  directions.resize(std::min(directions.size(), static_cast<std::size_t>(most)));
  std::string text;
  for (const double d : directions) text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", d);
  return text;
}

} // namespace

std::vector<double> bond_directions(const EcmParameters& ecm) {
  std::vector<double> directions;
  for (const Vec2& X : bonds(ecm)) directions.push_back(axis_of(X));
  std::ranges::sort(directions);
  const auto same = [](double a, double b) { return b - a < same_direction; };
  directions.erase(std::unique(directions.begin(), directions.end(), same), directions.end());
  return directions;
}

FibreBonds fibre_bonds(const Parameters& p) {
  FibreBonds found;
  if (p.fibres.arrangement == FibreArrangement::none) return found;
  const Kernel kernel(p.ecm.smoothing_length);
  Vec2 sum = Vec2::Zero(); // of axes: angles count twice
  double weights = 0.0;
  for (const Vec2& X : bonds(p.ecm)) {
    if (!joined(X, p.fibres)) continue;
    ++found.count;
    const double w = kernel.W(X.norm());
    const double twice = 2.0 * std::atan2(X.y(), X.x());
    sum += w * Vec2(std::cos(twice), std::sin(twice));
    weights += w;
  }
  if (sum.norm() > 1e-9 * weights)
    found.mean_deg =
        axis_of(Vec2(std::cos(0.5 * std::atan2(sum.y(), sum.x())), std::sin(0.5 * std::atan2(sum.y(), sum.x()))));
  return found;
}

std::string fault_of_fibres(const Parameters& p) {
  if (p.fibres.arrangement != FibreArrangement::uniaxial) return {};
  const double direction = p.fibres.direction_deg;
  const double half = p.fibres.half_angle_deg;
  const std::vector<double> directions = bond_directions(p.ecm);
  const bool hexagonal = p.ecm.lattice == Lattice::hexagonal;
  if (fibre_bonds(p).count == 0)
    return fmt::format("no bond of the {} lattice lies within fibres.half_angle_deg = {:.4g} of fibres.direction_deg = "
                       "{:.4g}, so there would be no fibres; the nearest bonds lie at {} degrees",
                       hexagonal ? "hexagonal" : "square", half, direction, nearest_directions(directions, direction));
  const auto on_boundary = [&](double d) { return std::abs(between(d, direction) - half) < same_direction; };
  if (hexagonal && std::ranges::any_of(directions, on_boundary))
    return fmt::format(
        "bonds of the hexagonal lattice lie exactly fibres.half_angle_deg = {:.4g} off "
        "fibres.direction_deg = {:.4g}; fibres on them would make the matrix stiff across its fibres; take a half "
        "angle of {:.4g}, without them, or {:.4g}, with them",
        half, direction, half - 1.0, half + 1.0);
  return {};
}

} // namespace matrigrate
