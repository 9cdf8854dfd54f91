#include "core/live.hpp"

#include "parameters/read.hpp"
#include "simulation/start.hpp"
#include "state/image.hpp"

#include <algorithm>
#include <utility>

namespace matrigrate::live {

namespace {

run::Cadence rows(const Parameters& p) { return {p.output.track_interval, p.run.time_step}; }

} // namespace

Followed::Followed(const Parameters& p) : m_simulation(p), m_rows(rows(p)) { keep_track(); }

Followed::Followed(const Parameters& p, std::string_view image) : m_simulation(p, state_of(image)), m_rows(rows(p)) {
  m_rows.due(state().t); // its row was taken before
}

bool Followed::done() const { return state().t >= parameters().run.duration - 0.5 * parameters().run.time_step; }

void Followed::march(double t_end, const std::function<bool()>& enough) {
  m_simulation.march(std::min(t_end, parameters().run.duration), {}, [&](const State& /*now*/) {
    keep_track();
    return !enough();
  });
}

void Followed::change(const std::vector<std::string>& overrides) {
  m_simulation.change(apply_overrides(parameters(), overrides, start_rules()), {}, [&](const State& /*now*/) {
    keep_track();
    return true;
  });
  m_rows = rows(parameters());
  m_rows.due(state().t);
}

std::vector<TrackRow> Followed::take_tracks() { return std::exchange(m_tracks, {}); }

std::string Followed::image() const { return image_of(state()); }

void Followed::keep_track() {
  if (!m_rows.due(state().t)) return;
  for (const TrackRow& row : track_rows(state())) m_tracks.push_back(row);
}

} // namespace matrigrate::live
