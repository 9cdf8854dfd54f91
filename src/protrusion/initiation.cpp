#include "protrusion/initiation.hpp"

#include "base/random.hpp"
#include "protrusion/membership.hpp"

#include <cmath>

namespace matrigrate {

bool has_room(const CortexState& c, std::size_t i, std::span<const int> of_particle, const ProtrusionParameters& p) {
  for (int k = -p.half_width; k <= p.half_width; ++k)
    if (of_particle[c.along(i, k)] != no_protrusion) return false;
  return true;
}

namespace {

/// A protrusion is born around particle i; it grows from `centre` towards it. The first of all sets the polarization.
void bear(State& s, std::size_t i, const Vec2& centre) {
  const auto entity = static_cast<std::uint32_t>(i);
  const Vec2 direction = (s.cortex.x[i] - centre).normalized();
  Protrusion born{.centre = entity, .since = s.t, .phase = Growing{direction}, .record = {}};
  born.record.id = ++s.initiated;
  born.record.centre = entity;
  born.record.t_initiation = s.t;
  s.protrusions.push_back(born);
  if (!s.polarization) s.polarization = std::atan2(direction.y(), direction.x());
}

void initiate_at_a_rate(State& s, const Parameters& p, std::span<const std::uint8_t> of_front, const Vec2& centre) {
  const double probability = event_probability(p.protrusion.initiation_rate, p.run.time_step);
  std::vector<int> of_particle = membership(s, p).of_particle;
  for (std::size_t i = 0; i < s.cortex.size(); ++i) {
    if (!of_front[i]) continue;
    if (uniform(p.run.seed, Purpose::initiation, s.step, static_cast<std::uint32_t>(i)) >= probability) continue;
    if (!has_room(s.cortex, i, of_particle, p.protrusion)) continue;
    bear(s, i, centre);
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

void keep_up_number(State& s, const Parameters& p, std::span<const std::uint8_t> of_front, const Vec2& centre) {
  if (s.protrusions.size() >= static_cast<std::size_t>(p.protrusion.number)) return;
  const double draw = uniform(p.run.seed, Purpose::initiation, s.step, 0);
  const std::size_t i = candidate(of_front, p.protrusion.rear_share, draw);
  if (has_room(s.cortex, i, membership(s, p).of_particle, p.protrusion)) bear(s, i, centre);
}

} // namespace

void initiate(State& s, const Parameters& p, std::span<const std::uint8_t> of_front, const Vec2& centre, double area) {
  if (p.protrusion.number == 0)
    initiate_at_a_rate(s, p, of_front, centre);
  else if (area <= p.protrusion.area_limit)
    keep_up_number(s, p, of_front, centre);
}

} // namespace matrigrate
