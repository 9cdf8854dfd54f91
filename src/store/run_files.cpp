#include "store/run_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
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
  return {{"duration_s", "duration [s]", r.duration},
          {"v_migr_abs_um_per_h", "speed, start to end [um/h]", r.v_migr_abs},
          {"v_migr_path_60s_um_per_h", "speed along the path, sampled every 60 s [um/h]", r.v_migr_path_60s},
          {"v_migr_path_600s_um_per_h", "speed along the path, sampled every 600 s [um/h]", r.v_migr_path_600s},
          {"n_protrusions", "protrusions initiated", count(r.n_protrusions)},
          {"n_unadhered", "of them, never adhered", count(r.n_unadhered)},
          {"tau_prot_min", "life of a mature adhesion, mean [min]", r.tau_prot.value},
          {"n_tau_prot", "adhesions in this mean", count(r.tau_prot.n)},
          {"n_censored", "mature adhesions still alive, not in this mean", count(r.n_censored)},
          {"l_prot_um", "length at the end of growth, mean [um]", r.l_prot.value},
          {"f_mat", "maturation, mean [-]", r.f_mat.value},
          {"force_nN", "force at disassembly, mean [nN]", r.force.value},
          {"f_adh_rel", "force at disassembly over f_mat F_am, mean [-]", r.f_adh_rel.value},
          {"n_simultaneous_mean", "protrusions at a time, mean", r.mean_simultaneous},
          {"n_simultaneous_max", "protrusions at a time, most", count(r.most_simultaneous)},
          {"msd_slope", "log-log slope of the mean square displacement, lags of 10 min to half the run", r.msd_slope},
          {"path_angle_deg", "mean angle of the path, sampled every 600 s, to uniaxial fibres [degrees]", r.path_angle},
          {"f_mat_along", "maturation of protrusions along uniaxial fibres, mean [-]", r.along.f_mat.value},
          {"f_mat_across", "maturation of protrusions across uniaxial fibres, mean [-]", r.across.f_mat.value},
          {"share_ruptured_along", "share of adhesions along uniaxial fibres that ended by rupture",
           r.along.ruptured.value},
          {"share_ruptured_across", "share of adhesions across uniaxial fibres that ended by rupture",
           r.across.ruptured.value}};
}

std::vector<NamedValue> shown_values(const ReadOuts& r, const Parameters& p) {
  std::vector<NamedValue> values = named_values(r);
  if (p.fibres.arrangement == FibreArrangement::uniaxial) return values;
  constexpr std::array<std::string_view, 5> of_fibres{"path_angle_deg", "f_mat_along", "f_mat_across",
                                                      "share_ruptured_along", "share_ruptured_across"};
  std::erase_if(values, [&](const NamedValue& v) { return std::ranges::find(of_fibres, v.name) != of_fibres.end(); });
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
