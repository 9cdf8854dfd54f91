#include "store/run_files.hpp"

#include "observe/readout_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace matrigrate::io {

std::vector<std::string_view> track_columns() {
  return {
      "track",          "t_s",       "x_um",       "y_um",          "area_um2",    "perimeter_um", "polarization_rad",
      "n_simultaneous", "n_growing", "n_maturing", "n_contracting", "n_finishing", "n_initiated",  "step"};
}

std::vector<Field> fields(const TrackRow& row) {
  return {count(1),
          row.t,
          row.centre.x(),
          row.centre.y(),
          row.area,
          row.perimeter,
          row.polarization.value_or(never),
          count(row.alive()),
          count(row.in_phase[0]),
          count(row.in_phase[1]),
          count(row.in_phase[2]),
          count(row.in_phase[3]),
          count(row.initiated),
          row.step};
}

std::vector<std::string_view> health_columns() {
  return {"t_s",
          "step",
          "solver_iterations",
          "solver_iterations_max",
          "solver_residual",
          "solver_residual_max",
          "area_ratio",
          "density_min",
          "density_max",
          "n_density_bounds",
          "n_orphans",
          "n_torn",
          "n_engulfed",
          "n_solid_inside",
          "deepest_solid_um",
          "crosses_itself",
          "fastest_um_per_s",
          "force_imbalance"};
}

std::vector<Field> fields(const HealthRow& row) {
  return {row.t,
          row.step,
          count(static_cast<std::size_t>(row.iterations)),
          count(static_cast<std::size_t>(row.most_iterations)),
          row.residual,
          row.largest_residual,
          row.area_ratio,
          row.density_min,
          row.density_max,
          count(row.density_bounds),
          count(row.orphans),
          count(row.torn),
          count(row.engulfed),
          count(row.solid_inside),
          row.deepest_solid,
          count(row.crosses_itself ? 1 : 0),
          row.fastest,
          row.force_imbalance};
}

std::vector<std::string_view> protrusion_columns() {
  return {"id",      "centre_particle", "t_initiation_s", "t_adhesion_s", "t_mature_s", "t_disassembly_s",
          "t_end_s", "length_um",       "direction_deg",  "f_mat",        "force_nN",   "f_adh_rel",
          "cause"};
}

std::vector<Field> fields(const ProtrusionRecord& r, const ActomyosinParameters& p) {
  return {count(r.id),  count(r.centre), r.t_initiation,
          r.t_adhesion, r.t_mature,      r.t_disassembly,
          r.t_end,      r.length,        r.direction * 180.0 / std::numbers::pi,
          r.f_mat,      r.force,         relative_force(r, p),
          name(r.cause)};
}

std::string protrusions_csv(std::span<const ProtrusionRecord> records, const ActomyosinParameters& p) {
  const auto columns = protrusion_columns();
  std::string text = csv_line({columns.begin(), columns.end()});
  for (const ProtrusionRecord& r : records) text += csv_line(fields(r, p));
  return text;
}

std::string msd_csv(std::span<const MsdPoint> points) {
  std::string text = csv_line({std::string_view("lag_s"), std::string_view("msd_um2"), std::string_view("samples")});
  for (const MsdPoint& point : points) text += csv_line({point.lag, point.msd, count(point.samples)});
  return text;
}

std::vector<NamedValue> named_values(const ReadOuts& r) {
  std::vector<NamedValue> values;
  for (const ReadOutSpec& spec : readout_table())
    values.push_back({spec.name, spec.meaning_with_unit(),
                      std::visit([](const auto value) { return Field(value); }, spec.value(r))});
  return values;
}

std::vector<NamedValue> shown_values(const ReadOuts& r, const Parameters& p) {
  std::vector<NamedValue> values = named_values(r);
  if (p.fibres.arrangement == FibreArrangement::uniaxial) return values;
  std::erase_if(values, [](const NamedValue& v) { return find_readout(v.name)->of_fibres; });
  return values;
}

std::string result_sentence(const ReadOuts& r) {
  std::string text;
  if (std::isfinite(r.v_migr_abs)) text = fmt::format("{:.3g} um/h from start to end, ", r.v_migr_abs);
  if (std::isfinite(r.msd_slope))
    text += fmt::format("{} (MSD slope {:.3g}), ",
                        r.msd_slope > 1.2   ? "persistent"
                        : r.msd_slope < 0.8 ? "confined"
                                            : "like a random walk",
                        r.msd_slope);
  return text + fmt::format("{} protrusion{}.", r.n_protrusions, r.n_protrusions == 1 ? "" : "s");
}

std::string readable(const Field& value) {
  const double* number = std::get_if<double>(&value);
  if (number == nullptr) return csv_line({value}).substr(0, csv_line({value}).size() - 1);
  return std::isnan(*number) ? "-" : fmt::format("{:.4g}", *number);
}

std::string summary_csv(const ReadOuts& r) {
  std::vector<Field> header;
  std::vector<Field> row;
  for (const NamedValue& v : named_values(r)) {
    header.emplace_back(v.name);
    row.push_back(v.value);
  }
  return csv_line(header) + csv_line(row);
}

std::string summary_json(const ReadOuts& r) {
  nlohmann::ordered_json summary;
  for (const NamedValue& v : named_values(r)) // NaN is written as null
    std::visit([&](const auto& value) { summary[std::string(v.name)] = value; }, v.value);
  return summary.dump(2) + "\n";
}

} // namespace matrigrate::io
