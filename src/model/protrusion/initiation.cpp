#include "protrusion/initiation.hpp"

#include "base/random.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/membership.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace matrigrate {

bool has_room(const CortexState& c, std::size_t i, std::span<const int> of_particle, const ProtrusionParameters& p) {
  for (int k = -p.half_width; k <= p.half_width; ++k)
    if (of_particle[c.along(i, k)] != no_protrusion) return false;
  return true;
}

double facing(const CortexState& c, std::size_t i, const Outline& outline, const ProtrusionParameters& p) {
  const Vec2 direction = (c.x[i] - outline.centre).normalized();
  double sum = 0.0;
  for (int k = -p.tip_half_width; k <= p.tip_half_width; ++k)
    sum += std::max(0.0, outline.normals[c.along(i, k)].dot(direction));
  return sum / (2.0 * p.tip_half_width + 1.0);
}

void begin_protrusion(Cell& cell, std::size_t i, const Vec2& centre, double t, const ProtrusionParameters& p) {
  const auto entity = static_cast<std::uint32_t>(i);
  const Vec2 direction = (cell.cortex.x[i] - centre).normalized();
  Protrusion born{
      .centre = entity, .since = t, .phase = Growing{direction, base_width(cell.cortex, i, p)}, .record = {}};
  born.record.id = ++cell.initiated;
  born.record.centre = entity;
  born.record.t_initiation = t;
  cell.protrusions.push_back(born);
  if (!cell.polarization) cell.polarization = std::atan2(direction.y(), direction.x());
}

namespace {

bool may_begin(const CortexState& c, std::size_t i, std::span<const int> of_particle, const Outline& outline,
               const ProtrusionParameters& p) {
  return has_room(c, i, of_particle, p) && facing(c, i, outline, p) >= p.least_facing;
}

void initiate_at_a_rate(Cell& cell, const Instant& now, const Parameters& p, double dt, const Outline& outline) {
  const auto probability = [&](std::size_t i) {
    return event_probability((outline.propensity.empty() ? 1.0 : outline.propensity[i]) * outline.rate[i], dt);
  };
  std::vector<int> of_particle = membership(cell, p).of_particle;
  for (std::size_t i = 0; i < cell.cortex.size(); ++i) {
    if (!outline.of_front[i]) continue;
    if (uniform(p.run.seed, Purpose::initiation, now.step, static_cast<std::uint32_t>(i), cell.id) >= probability(i))
      continue;
    if (!may_begin(cell.cortex, i, of_particle, outline, p.protrusion)) continue;
    begin_protrusion(cell, i, outline.centre, now.t, p.protrusion);
    of_particle = membership(cell, p).of_particle;
  }
}

/// How likely each particle is a candidate, front or rear. A rate that is the same for all tells none from another.
std::vector<double> likelihoods(const Outline& outline) {
  const bool even = std::ranges::all_of(outline.rate, [&](double rate) { return rate == outline.rate.front(); });
  std::vector<double> all(outline.rate.size(), 1.0);
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = (outline.propensity.empty() ? 1.0 : outline.propensity[i]) * (even ? 1.0 : outline.rate[i]);
  return all;
}

/// The particle that a uniform draw falls on, each with the weight of front or rear times its likelihood.
std::size_t candidate(std::span<const std::uint8_t> of_front, std::span<const double> likely, double rear_share,
                      double draw) {
  const auto weight = [&](std::size_t i) { return (of_front[i] ? 1.0 : rear_share) * likely[i]; };
  double sum = 0.0;
  for (std::size_t i = 0; i < of_front.size(); ++i) sum += weight(i);
  double left = draw * sum;
  std::size_t i = 0;
  while (i + 1 < of_front.size() && left >= weight(i)) left -= weight(i++);
  return i;
}

/// Number of candidates that have been drawn up to time t: one in each candidate_interval.
std::uint64_t candidates_until(double t, const ProtrusionParameters& p) {
  return static_cast<std::uint64_t>(std::max(0.0, std::floor(t / p.candidate_interval + 1e-6))); // t is a sum of steps
}

void keep_up_number(Cell& cell, const Instant& now, const Parameters& p, double dt, const Outline& outline) {
  const std::uint64_t last = candidates_until(now.t, p.protrusion);
  for (std::uint64_t n = candidates_until(now.t - dt, p.protrusion) + 1; n <= last; ++n) {
    if (cell.protrusions.size() >= static_cast<std::size_t>(p.protrusion.number)) return;
    const double draw = uniform(p.run.seed, Purpose::initiation, n, 0, cell.id);
    const std::vector<double> likely = likelihoods(outline);
    const std::size_t i = candidate(outline.of_front, likely, p.protrusion.rear_share, draw);
    if (likely[i] <= 0.0) continue; // of all particles
    if (may_begin(cell.cortex, i, membership(cell, p).of_particle, outline, p.protrusion))
      begin_protrusion(cell, i, outline.centre, now.t, p.protrusion);
  }
}

} // namespace

void initiate(Cell& cell, const Instant& now, const Parameters& p, double dt, const Outline& outline) {
  if (p.protrusion.number == 0)
    initiate_at_a_rate(cell, now, p, dt, outline);
  else if (outline.area <= p.protrusion.area_limit)
    keep_up_number(cell, now, p, dt, outline);
}

} // namespace matrigrate
