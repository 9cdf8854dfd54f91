#include "protrusion/initiation.hpp"

#include "base/random.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/membership.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate {

bool has_room(const CortexState& c, std::size_t i, std::span<const int> of_particle, const ProtrusionParameters& p) {
  for (int k = -p.half_width; k <= p.half_width; ++k)
    if (of_particle[c.along(i, k)] != no_protrusion) return false;
  return true;
}

double facing(const CortexState& c, std::size_t i, const Outline& cell, const ProtrusionParameters& p) {
  const Vec2 direction = (c.x[i] - cell.centre).normalized();
  double sum = 0.0;
  for (int k = -p.tip_half_width; k <= p.tip_half_width; ++k)
    sum += std::max(0.0, cell.normals[c.along(i, k)].dot(direction));
  return sum / (2.0 * p.tip_half_width + 1.0);
}

void begin_protrusion(State& s, std::size_t i, const Vec2& centre, const ProtrusionParameters& p) {
  const auto entity = static_cast<std::uint32_t>(i);
  const Vec2 direction = (s.cortex.x[i] - centre).normalized();
  Protrusion born{
      .centre = entity, .since = s.t, .phase = Growing{direction, base_width(s.cortex, i, p)}, .record = {}};
  born.record.id = ++s.initiated;
  born.record.centre = entity;
  born.record.t_initiation = s.t;
  s.protrusions.push_back(born);
  if (!s.polarization) s.polarization = std::atan2(direction.y(), direction.x());
}

namespace {

bool may_begin(const CortexState& c, std::size_t i, std::span<const int> of_particle, const Outline& cell,
               const ProtrusionParameters& p) {
  return has_room(c, i, of_particle, p) && facing(c, i, cell, p) >= p.least_facing;
}

void initiate_at_a_rate(State& s, const Parameters& p, double dt, const Outline& cell) {
  const double probability = event_probability(p.protrusion.initiation_rate, dt);
  std::vector<int> of_particle = membership(s, p).of_particle;
  for (std::size_t i = 0; i < s.cortex.size(); ++i) {
    if (!cell.of_front[i]) continue;
    if (uniform(p.run.seed, Purpose::initiation, s.step, static_cast<std::uint32_t>(i)) >= probability) continue;
    if (!may_begin(s.cortex, i, of_particle, cell, p.protrusion)) continue;
    begin_protrusion(s, i, cell.centre, p.protrusion);
    of_particle = membership(s, p).of_particle;
  }
}

/// The particle that a uniform draw falls on, each with the weight of front or rear.
std::size_t candidate(std::span<const std::uint8_t> of_front, double rear_share, double draw) {
  const auto weight = [&](std::size_t i) { return of_front[i] ? 1.0 : rear_share; };
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

void keep_up_number(State& s, const Parameters& p, double dt, const Outline& cell) {
  const std::uint64_t last = candidates_until(s.t, p.protrusion);
  for (std::uint64_t n = candidates_until(s.t - dt, p.protrusion) + 1; n <= last; ++n) {
    if (s.protrusions.size() >= static_cast<std::size_t>(p.protrusion.number)) return;
    const double draw = uniform(p.run.seed, Purpose::initiation, n, 0);
    const std::size_t i = candidate(cell.of_front, p.protrusion.rear_share, draw);
    if (may_begin(s.cortex, i, membership(s, p).of_particle, cell, p.protrusion))
      begin_protrusion(s, i, cell.centre, p.protrusion);
  }
}

} // namespace

void initiate(State& s, const Parameters& p, double dt, const Outline& cell) {
  if (p.protrusion.number == 0)
    initiate_at_a_rate(s, p, dt, cell);
  else if (cell.area <= p.protrusion.area_limit)
    keep_up_number(s, p, dt, cell);
}

} // namespace matrigrate
