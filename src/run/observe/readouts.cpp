#include "observe/readouts.hpp"

#include "protrusion/adhesion.hpp"
#include "tracks/read_tracks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace matrigrate {

namespace {

constexpr double seconds_an_hour = 3600.0;
constexpr double seconds_a_minute = 60.0;

/// Mean of a value over the records, those without it left out.
template <class Value>
Mean mean_of(std::span<const ProtrusionRecord> records, const Value& value) {
  Mean mean;
  double sum = 0.0;
  for (const ProtrusionRecord& r : records) {
    const double v = value(r);
    if (std::isnan(v)) continue;
    sum += v;
    ++mean.n;
  }
  if (mean.n > 0) mean.value = sum / static_cast<double>(mean.n);
  return mean;
}

bool matured(const ProtrusionRecord& r) { return !std::isnan(r.t_mature); }

void add_protrusions(ReadOuts& out, std::span<const ProtrusionRecord> records, const Parameters& p) {
  out.n_protrusions = records.size();
  for (const ProtrusionRecord& r : records) {
    out.n_unadhered += r.cause == EndCause::unadhered ? 1 : 0;
    out.n_censored += matured(r) && r.cause == EndCause::none ? 1 : 0;
  }
  // A difference or a ratio with a time or value that has not come is NaN, and so left out.
  out.tau_prot = mean_of(records, [](const auto& r) { return (r.t_disassembly - r.t_mature) / seconds_a_minute; });
  out.l_prot = mean_of(records, [](const auto& r) { return std::isnan(r.t_adhesion) ? undefined : r.length; });
  out.f_mat = mean_of(records, [](const auto& r) { return r.f_mat; });
  out.force = mean_of(records, [](const auto& r) { return matured(r) ? r.force : undefined; });
  std::vector<double> forces;
  for (const ProtrusionRecord& r : records) forces.push_back(relative_force(r, p));
  out.f_adh_rel = mean_of(records, [&](const auto& r) { return relative_force(r, p); });
  out.share_low_force = share_of_low_forces(forces);
}

/// @param fibres  their direction from the x axis [rad]   @param across  which of the two is wanted
OrientedProtrusions oriented(std::span<const ProtrusionRecord> records, double fibres, bool across) {
  const auto wanted = [&](const ProtrusionRecord& r) {
    return std::cos(2.0 * (r.direction - fibres)) < 0.0 ? across : !across; // of a line: over 45 degrees off, or not
  };
  return {.f_mat = mean_of(records, [&](const auto& r) { return wanted(r) ? r.f_mat : undefined; }),
          .ruptured = mean_of(records, [&](const auto& r) {
            if (!wanted(r)) return undefined;
            return r.cause == EndCause::rupture ? 1.0 : r.cause == EndCause::disassembly ? 0.0 : undefined;
          })};
}

/// NaN where nothing moved.
double migration_index(std::span<const TrackRow> rows) {
  double length = 0.0;
  const TrackRow* last = &rows.front();
  for (const TrackRow& row : rows.subspan(1)) {
    if (std::abs(std::remainder(row.t, 600.0)) > 1e-6) continue;
    length += std::hypot(row.centre.x() - last->centre.x(), row.centre.y() - last->centre.y());
    last = &row;
  }
  return length > 0.0 ? (last->centre.x() - rows.front().centre.x()) / length : undefined;
}

/// Cosine between the way of a cell and the direction away from its nearest neighbour at the start.
double parting_index(std::span<const CellResult> cells, const CellResult& own) {
  double least = std::numeric_limits<double>::infinity();
  double away_x = 0.0;
  double away_y = 0.0;
  const Vec2 start = own.rows.front().centre;
  for (const CellResult& other : cells) {
    if (&other == &own || other.rows.empty()) continue;
    const double dx = start.x() - other.rows.front().centre.x();
    const double dy = start.y() - other.rows.front().centre.y();
    const double distance = std::hypot(dx, dy);
    if (distance >= least) continue;
    least = distance;
    away_x = dx / distance;
    away_y = dy / distance;
  }
  const double dx = own.rows.back().centre.x() - start.x();
  const double dy = own.rows.back().centre.y() - start.y();
  const double way = std::hypot(dx, dy);
  return way > 0.0 ? (away_x * dx + away_y * dy) / way : undefined;
}

/// Centres at multiples of the interval from the first row on; empty if one of them is missing in between.
std::vector<Vec2> sampled(std::span<const TrackRow> rows, double interval) {
  std::vector<Vec2> centres;
  const double tolerance = 1e-6 * interval;
  for (const TrackRow& row : rows) {
    const double next = rows.front().t + interval * static_cast<double>(centres.size());
    if (row.t < next - tolerance) continue;
    if (row.t > next + tolerance) return {};
    centres.push_back(row.centre);
  }
  return centres;
}

} // namespace

double share_of_low_forces(std::span<const double> relative_forces) {
  double low = 0.0;
  double all = 0.0;
  for (const double force : relative_forces) {
    if (!std::isfinite(force)) continue;
    low += force < low_relative_force ? 1.0 : 0.0;
    all += 1.0;
  }
  return all > 0.0 ? low / all : undefined;
}

double relative_force(const ProtrusionRecord& r, const Parameters& p) { return r.force / mature_pull(r.f_mat, p); }

double path_length(std::span<const TrackRow> rows, double interval) {
  const double tolerance = 1e-6 * interval; // times are multiples of the step
  if (rows.size() < 2 || rows.back().t - rows.front().t < interval - tolerance) return undefined;
  double length = 0.0;
  const TrackRow* last = &rows.front();
  double next = last->t + interval;
  for (const TrackRow& row : rows.subspan(1)) {
    if (row.t > (&row - 1)->t + 1.01 * interval) return undefined;
    if (row.t < next - tolerance && &row != &rows.back()) continue;
    length += (row.centre - last->centre).norm();
    last = &row;
    next += interval;
  }
  return length;
}

ReadOuts readouts(std::span<const TrackRow> rows, std::span<const ProtrusionRecord> records, const Parameters& p) {
  ReadOuts out;
  add_protrusions(out, records, p);
  const double fibres = p.fibres.direction_deg * std::numbers::pi / 180.0;
  const bool uniaxial = p.fibres.arrangement == FibreArrangement::uniaxial && p.fibres.field.direction_deg.empty();
  if (uniaxial) {
    out.along = oriented(records, fibres, false);
    out.across = oriented(records, fibres, true);
  }
  if (rows.empty()) return out;
  double alive = 0.0;
  double two_or_three = 0.0;
  for (const TrackRow& row : rows) {
    alive += row.alive();
    two_or_three += row.alive() == 2 || row.alive() == 3 ? 1.0 : 0.0;
    out.max_simultaneous = std::max<std::size_t>(out.max_simultaneous, row.alive());
  }
  out.mean_simultaneous = alive / static_cast<double>(rows.size());
  out.share_2_or_3 = two_or_three / static_cast<double>(rows.size());
  out.migration_index = migration_index(rows);
  out.duration = rows.back().t - rows.front().t;
  if (!(out.duration > 0.0)) return out;
  const double hours = out.duration / seconds_an_hour;
  out.v_migr_abs = (rows.back().centre - rows.front().centre).norm() / hours;
  out.v_migr_path_60s = path_length(rows, 60.0) / hours;
  out.v_migr_path_600s = path_length(rows, 600.0) / hours;
  out.msd_slope = msd_slope(mean_square_displacement(rows, 600.0));
  if (uniaxial) out.guidance = guidance(rows, fibres, 600.0);
  return out;
}

void add_group(std::span<CellResult> cells, std::span<const GroupRow> group) {
  if (cells.size() < 2) return;
  double contact = 0.0;
  double orders = 0.0;
  double ordered = 0.0;
  for (const GroupRow& row : group) {
    contact += row.contacts > 0 ? 1.0 : 0.0;
    if (!std::isfinite(row.order)) continue;
    orders += row.order;
    ordered += 1.0;
  }
  for (CellResult& cell : cells) {
    ReadOuts& out = cell.readouts;
    if (!cell.rows.empty()) out.parting_index = parting_index(cells, cell);
    if (group.empty()) continue;
    out.share_in_contact = contact / static_cast<double>(group.size());
    out.nearest = group.back().nearest;
    out.order = ordered > 0.0 ? orders / ordered : undefined;
  }
}

std::vector<CellResult> cell_results(const State& s, std::span<const TrackRow> rows, std::span<const GroupRow> group,
                                     const Parameters& p) {
  std::vector<CellResult> all;
  for (const Cell& cell : s.cells) {
    CellResult& result = all.emplace_back(
        CellResult{.cell = cell.id, .rows = rows_of(rows, cell.id), .records = protrusion_records(cell)});
    result.readouts = readouts(result.rows, result.records, p);
  }
  add_group(all, group);
  return all;
}

std::vector<MsdPoint> mean_square_displacement(std::span<const TrackRow> rows, double interval) {
  tracks::Track track;
  for (const Vec2& x : sampled(rows, interval)) {
    track.k.push_back(track.k.size());
    track.x.push_back(x.x());
    track.y.push_back(x.y());
  }
  const tracks::Displacements found = tracks::displacements(track, track.span() / 2);
  std::vector<MsdPoint> points;
  for (std::size_t k = 0; k < found.squares.size(); ++k)
    points.push_back({.lag = interval * static_cast<double>(k + 1),
                      .msd = found.squares[k] / found.pairs[k],
                      .samples = static_cast<std::size_t>(found.pairs[k])});
  return points;
}

double msd_slope(std::span<const MsdPoint> points) {
  std::vector<double> lags, squares;
  for (const MsdPoint& point : points) {
    lags.push_back(point.lag);
    squares.push_back(point.msd);
  }
  return tracks::log_slope(lags, squares, 3);
}

Guidance guidance(std::span<const TrackRow> rows, double direction, double interval) {
  Guidance found;
  const std::vector<Vec2> x = sampled(rows, interval);
  if (x.empty()) return found;
  const Vec2 d(std::cos(direction), std::sin(direction));
  const auto angle = [&](const Vec2& step) {
    return std::atan2(std::abs(cross(d, step)), std::abs(d.dot(step))) * 180.0 / std::numbers::pi;
  };
  double sum = 0.0, weighted = 0.0, length = 0.0, steps = 0.0;
  for (std::size_t k = 1; k < x.size(); ++k) {
    const Vec2 step = x[k] - x[k - 1];
    if (!(step.norm() > 0.0)) continue;
    weighted += step.norm() * angle(step);
    length += step.norm();
    sum += angle(step);
    steps += 1.0;
  }
  if (length > 0.0) {
    found.path_angle = weighted / length;
    found.step_angle = sum / steps;
  }
  const Vec2 net = rows.back().centre - rows.front().centre;
  if (net.norm() > 0.0) found.net_angle = angle(net);
  for (std::size_t k = 0; k < found.ratios.size(); ++k) {
    constexpr std::array lags{3600.0, 10800.0, 21600.0}; // [s]
    const auto lag = static_cast<std::size_t>(std::llround(lags[k] / interval));
    double along = 0.0, across = 0.0;
    for (std::size_t i = 0; i + lag < x.size(); ++i) {
      const Vec2 step = x[i + lag] - x[i];
      along += d.dot(step) * d.dot(step);
      across += cross(d, step) * cross(d, step);
    }
    if (across > 0.0) found.ratios[k] = along / across;
  }
  return found;
}

} // namespace matrigrate
