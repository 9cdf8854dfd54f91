#include "observe/tracks.hpp"

#include "cell/geometry.hpp"

#include <algorithm>
#include <numeric>

namespace matrigrate {

std::uint32_t TrackRow::alive() const { return std::accumulate(in_phase.begin(), in_phase.end(), 0U); }

TrackRow track_row(const State& s) {
  TrackRow row{.t = s.t,
               .step = s.step,
               .centre = centroid(s.cortex),
               .area = area(s.cortex),
               .perimeter = perimeter(s.cortex),
               .polarization = s.polarization,
               .initiated = s.initiated};
  for (const Protrusion& protrusion : s.protrusions) ++row.in_phase[protrusion.phase.index()];
  return row;
}

std::vector<ProtrusionRecord> protrusion_records(const State& s) {
  std::vector<ProtrusionRecord> records = s.ended;
  for (const Protrusion& protrusion : s.protrusions) records.push_back(protrusion.record);
  std::ranges::sort(records, {}, &ProtrusionRecord::id);
  return records;
}

} // namespace matrigrate
