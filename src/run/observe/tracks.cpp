#include "observe/tracks.hpp"

#include "cell/geometry.hpp"
#include "cell/nucleus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace matrigrate {

std::uint32_t TrackRow::alive() const { return std::accumulate(in_phase.begin(), in_phase.end(), 0U); }

TrackRow track_row(const Cell& cell, const Instant& now) {
  TrackRow row{.t = now.t,
               .step = now.step,
               .cell = cell.id,
               .centre = centre_of_mass(cell.cortex),
               .area = area(cell.cortex),
               .perimeter = perimeter(cell.cortex),
               .polarization = cell.polarization,
               .initiated = cell.initiated};
  for (const Protrusion& protrusion : cell.protrusions) ++row.in_phase[protrusion.phase.index()];
  if (cell.nucleus.size() > 0)
    row.nucleus = {.centre = centroid(cell.nucleus), .area = area(cell.nucleus), .aspect = aspect_ratio(cell.nucleus)};
  return row;
}

std::vector<TrackRow> track_rows(const State& s) {
  std::vector<TrackRow> rows;
  for (const Cell& cell : s.cells) rows.push_back(track_row(cell, s.now()));
  return rows;
}

std::vector<TrackRow> rows_of(std::span<const TrackRow> rows, std::uint32_t cell) {
  std::vector<TrackRow> own;
  std::ranges::copy_if(rows, std::back_inserter(own), [cell](const TrackRow& row) { return row.cell == cell; });
  return own;
}

std::vector<ProtrusionRecord> protrusion_records(const Cell& cell) {
  std::vector<ProtrusionRecord> records = cell.ended;
  for (const Protrusion& protrusion : cell.protrusions) records.push_back(protrusion.record);
  std::ranges::sort(records, {}, &ProtrusionRecord::id);
  return records;
}

} // namespace matrigrate

namespace matrigrate::observe {

std::string EvenTimes::text() const {
  return is_even() ? fmt::format("every {:g} s", interval)
                   : fmt::format("unevenly spaced, {:g} to {:g} s apart", least, most);
}

EvenTimes even_times(std::span<const double> times) {
  constexpr double same = 1e-3; // [s]
  EvenTimes found{.interval = 0.0, .even = times.size(), .all = times.size()};
  if (times.size() < 2) return found;
  found.interval = found.least = found.most = times[1] - times[0];
  for (std::size_t k = 1; k < times.size(); ++k) {
    found.least = std::min(found.least, times[k] - times[k - 1]);
    found.most = std::max(found.most, times[k] - times[k - 1]);
    if (std::abs(times[k] - times[0] - static_cast<double>(k) * found.interval) > same)
      found.even = std::min(found.even, k);
  }
  return found;
}

std::vector<double> times_of(std::span<const TrackRow> rows) {
  std::vector<double> times;
  for (const TrackRow& row : rows)
    if (times.empty() || row.t > times.back()) times.push_back(row.t);
  return times;
}

} // namespace matrigrate::observe
