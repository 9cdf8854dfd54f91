#include "observe/readouts.hpp"

#include "observe/displacement_statistics.hpp"
#include "protrusion/adhesion.hpp"

#include <algorithm>
#include <cmath>
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

std::size_t count(std::span<const ProtrusionRecord> records, bool (*which)(const ProtrusionRecord&)) {
  return static_cast<std::size_t>(std::ranges::count_if(records, which));
}

bool matured(const ProtrusionRecord& r) { return !std::isnan(r.t_mature); }
bool still_adheres(const ProtrusionRecord& r) { return matured(r) && r.cause == EndCause::none; }
bool unadhered(const ProtrusionRecord& r) { return r.cause == EndCause::unadhered; }

void add_protrusions(ReadOuts& out, std::span<const ProtrusionRecord> records, const Parameters& p) {
  out.n_protrusions = records.size();
  out.n_unadhered = count(records, unadhered);
  out.n_censored = count(records, still_adheres);
  // A difference or a ratio with a time or value that has not come is NaN, and so left out.
  out.tau_prot = mean_of(records, [](const auto& r) { return (r.t_disassembly - r.t_mature) / seconds_a_minute; });
  out.l_prot = mean_of(records, [](const auto& r) { return std::isnan(r.t_adhesion) ? undefined : r.length; });
  out.f_mat = mean_of(records, [](const auto& r) { return r.f_mat; });
  out.force = mean_of(records, [](const auto& r) { return matured(r) ? r.force : undefined; });
  out.f_adh_rel = mean_of(records, [&](const auto& r) { return relative_force(r, p); });
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

} // namespace

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
  for (const TrackRow& row : rows) {
    alive += row.alive();
    out.max_simultaneous = std::max<std::size_t>(out.max_simultaneous, row.alive());
  }
  out.mean_simultaneous = alive / static_cast<double>(rows.size());
  out.duration = rows.back().t - rows.front().t;
  if (!(out.duration > 0.0)) return out;
  const double hours = out.duration / seconds_an_hour;
  out.v_migr_abs = (rows.back().centre - rows.front().centre).norm() / hours;
  out.v_migr_path_60s = path_length(rows, 60.0) / hours;
  out.v_migr_path_600s = path_length(rows, 600.0) / hours;
  out.msd_slope = msd_slope(mean_square_displacement(rows, 600.0));
  if (uniaxial) out.path_angle = angle_to(rows, fibres, 600.0);
  return out;
}

std::vector<CellResult> cell_results(const State& s, std::span<const TrackRow> rows, const Parameters& p) {
  std::vector<CellResult> all;
  for (const Cell& cell : s.cells) {
    CellResult& result = all.emplace_back(
        CellResult{.cell = cell.id, .rows = rows_of(rows, cell.id), .records = protrusion_records(cell)});
    result.readouts = readouts(result.rows, result.records, p);
  }
  return all;
}

} // namespace matrigrate
