#include "observe/tracks.hpp"

#include "cell/geometry.hpp"
#include "cell/nucleus.hpp"
#include "contact/cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

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

namespace {

double spread_of(const std::vector<Vec2>& centres, const Vec2& mean) {
  double sum = 0.0;
  for (const Vec2& x : centres) sum += (x - mean).squaredNorm();
  return std::sqrt(sum / static_cast<double>(centres.size()));
}

double mean_nearest(const std::vector<Vec2>& centres) {
  if (centres.size() < 2) return undefined;
  double sum = 0.0;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < centres.size(); ++j)
      if (j != k) least = std::min(least, (centres[j] - centres[k]).squaredNorm());
    sum += std::sqrt(least);
  }
  return sum / static_cast<double>(centres.size());
}

/// The row of a cell that ends last before the window.
const TrackRow* before_window(std::span<const TrackRow> rows, std::uint32_t cell, double t) {
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    if (row->cell == cell && row->t <= t - group_window * (1.0 - 1e-9)) return &*row;
  return nullptr;
}

void add_motion(GroupRow& group, const State& s, const std::vector<Vec2>& centres, std::span<const TrackRow> rows) {
  Vec2 directions = Vec2::Zero();
  double speeds = 0.0;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const TrackRow* row = before_window(rows, s.cells[k].id, s.t);
    if (row == nullptr) return;
    const Vec2 d = centres[k] - row->centre;
    speeds += d.norm() / (s.t - row->t);
    if (d.norm() > 0.0) directions += d.normalized();
  }
  const auto n = static_cast<double>(centres.size());
  group.speed = 3600.0 * speeds / n;
  group.order = directions.norm() / n;
  if (group.order > 0.0) group.direction = std::atan2(directions.y(), directions.x());
}

} // namespace

GroupRow group_row(const State& s, std::span<const TrackRow> earlier, const Parameters& p) {
  GroupRow group{.t = s.t, .step = s.step};
  if (s.cells.empty()) return group;
  std::vector<Vec2> centres;
  for (const Cell& cell : s.cells) {
    centres.push_back(centre_of_mass(cell.cortex));
    group.centre += centres.back();
  }
  group.centre /= static_cast<double>(centres.size());
  group.spread = spread_of(centres, group.centre);
  group.nearest = mean_nearest(centres);
  add_motion(group, s, centres, earlier);
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const CellTouch& touch : cell_touches(s.cells, cell_reach(p.contact.cells))) {
    pairs.insert(std::minmax(touch.cell, touch.other));
    group.gap = std::fmin(group.gap, touch.gap);
  }
  group.contacts = pairs.size();
  return group;
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
