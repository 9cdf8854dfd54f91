#include "core/live.hpp"

#include "base/failure.hpp"
#include "parameters/read.hpp"
#include "simulation/march.hpp"
#include "simulation/same_start.hpp"
#include "simulation/start.hpp"
#include "simulation/start_rules.hpp"
#include "state/image.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace matrigrate::live {

Simulation::Simulation(const Parameters& p) : m_p(p), m_s(initial_state(p)) {
  m_w.emplace(m_s, m_p);
  keep_track();
}

Simulation::Simulation(const Parameters& p, std::string_view image) : m_p(p), m_s(state_of(image)) {
  m_w.emplace(m_s, m_p);
  m_next_track = m_p.output.track_interval * (std::floor(m_s.t / m_p.output.track_interval + 1e-6) + 1.0);
}

bool Simulation::done() const { return m_s.t >= m_p.run.duration - 0.5 * m_p.run.time_step; }

void Simulation::march(double t_end, const std::function<bool()>& enough) {
  matrigrate::march(m_s, m_p, *m_w, std::min(t_end, m_p.run.duration), {}, [&](const State& /*now*/) {
    keep_track();
    return !enough();
  });
}

Change Simulation::change(const std::vector<std::string>& overrides) {
  const Parameters after = apply_overrides(m_p, overrides, start_rules());
  if (auto faults = faults_of_change(m_p, after, ""); !faults.empty()) throw ConfigurationError(std::move(faults));
  const double dt = m_p.run.time_step;
  march(dt * std::ceil(m_s.t / dt - 1e-6), [] { return false; });
  m_p = after;
  m_w.emplace(m_s, m_p);
  return {m_s.t, overrides};
}

std::vector<TrackRow> Simulation::take_tracks() { return std::exchange(m_tracks, {}); }

std::string Simulation::image() const { return image_of(m_s); }

void Simulation::keep_track() {
  const double interval = m_p.output.track_interval;
  if (m_s.t < m_next_track - 1e-6) return;
  m_next_track = interval * (std::floor(m_s.t / interval + 1e-6) + 1.0);
  for (const TrackRow& row : track_rows(m_s, m_p.cell.centre_of_mass)) m_tracks.push_back(row);
}

} // namespace matrigrate::live
