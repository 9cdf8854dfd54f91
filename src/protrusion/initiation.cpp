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

void initiate(State& s, const Parameters& p, std::span<const std::uint8_t> of_front, const Vec2& centre) {
  const double probability = event_probability(p.protrusion.initiation_rate, p.run.time_step);
  std::vector<int> of_particle = membership(s, p).of_particle;
  for (std::size_t i = 0; i < s.cortex.size(); ++i) {
    if (!of_front[i]) continue;
    const auto entity = static_cast<std::uint32_t>(i);
    if (uniform(p.run.seed, Purpose::initiation, s.step, entity) >= probability) continue;
    if (!has_room(s.cortex, i, of_particle, p.protrusion)) continue;
    const Vec2 direction = (s.cortex.x[i] - centre).normalized();
    Protrusion born{.centre = entity, .since = s.t, .phase = Growing{direction}, .record = {}};
    born.record.id = ++s.initiated;
    born.record.centre = entity;
    born.record.t_initiation = s.t;
    s.protrusions.push_back(born);
    of_particle = membership(s, p).of_particle;
    if (!s.polarization) s.polarization = std::atan2(direction.y(), direction.x());
  }
}

} // namespace matrigrate
