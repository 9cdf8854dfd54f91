#include "observe/readout_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace matrigrate {

std::string ReadOutSpec::meaning_with_unit() const {
  return unit.empty() || unit == "-" ? std::string(meaning) : fmt::format("{} ({})", meaning, unit);
}

std::span<const ReadOutSpec> readout_table() {
  using Value = ReadOutValue;
  // clang-format off
  static constexpr std::array<ReadOutSpec, 33> table{{
      {.name = "duration_s", .label = "duration", .unit = "s", .meaning = "duration",
       .value = [](const ReadOuts& r) -> Value { return r.duration; }, .is_always = true},
      {.name = "v_migr_abs_um_per_h", .label = "v_migr_abs", .unit = "um/h", .meaning = "speed, start to end",
       .value = [](const ReadOuts& r) -> Value { return r.v_migr_abs; }, .usual = true, .is_always = true},
      {.name = "v_migr_path_60s_um_per_h", .label = "v_migr_path_60s", .unit = "um/h",
       .meaning = "speed along the path, sampled every 60 s",
       .value = [](const ReadOuts& r) -> Value { return r.v_migr_path_60s; }, .usual = true},
      {.name = "v_migr_path_600s_um_per_h", .label = "v_migr_path_600s", .unit = "um/h",
       .meaning = "speed along the path, sampled every 600 s",
       .value = [](const ReadOuts& r) -> Value { return r.v_migr_path_600s; }},
      {.name = "n_protrusions", .label = "n_protrusions", .unit = "", .meaning = "protrusions initiated",
       .value = [](const ReadOuts& r) -> Value { return r.n_protrusions; }, .usual = true},
      {.name = "n_unadhered", .label = "n_unadhered", .unit = "", .meaning = "protrusions that never adhered",
       .value = [](const ReadOuts& r) -> Value { return r.n_unadhered; }},
      {.name = "tau_prot_min", .label = "tau_prot", .unit = "min", .meaning = "lifetime of a mature adhesion, mean",
       .value = [](const ReadOuts& r) -> Value { return r.tau_prot.value; }, .usual = true},
      {.name = "n_tau_prot", .label = "n_tau_prot", .unit = "", .meaning = "mature adhesions that ended",
       .value = [](const ReadOuts& r) -> Value { return r.tau_prot.n; }},
      {.name = "n_censored", .label = "n_censored", .unit = "",
       .meaning = "mature adhesions still alive at the end",
       .value = [](const ReadOuts& r) -> Value { return r.n_censored; }},
      {.name = "l_prot_um", .label = "l_prot", .unit = "um", .meaning = "length of a protrusion at the end of growth, mean",
       .value = [](const ReadOuts& r) -> Value { return r.l_prot.value; }, .usual = true},
      {.name = "f_mat", .label = "f_mat", .unit = "-", .meaning = "maturation of protrusions, mean",
       .value = [](const ReadOuts& r) -> Value { return r.f_mat.value; }, .usual = true, .most = 1.0},
      {.name = "force_nN", .label = "force", .unit = "nN", .meaning = "force of an adhesion at disassembly, mean",
       .value = [](const ReadOuts& r) -> Value { return r.force.value; }},
      {.name = "f_adh_rel", .label = "f_adh_rel", .unit = "-", .meaning = "force of an adhesion at disassembly over 2 f_mat F_am (both strands), mean",
       .value = [](const ReadOuts& r) -> Value { return r.f_adh_rel.value; }, .usual = true},
      {.name = "n_simultaneous_mean", .label = "n_simultaneous_mean", .unit = "",
       .meaning = "protrusions at a time, mean",
       .value = [](const ReadOuts& r) -> Value { return r.mean_simultaneous; }},
      {.name = "n_simultaneous_max", .label = "n_simultaneous_max", .unit = "",
       .meaning = "protrusions at a time, most",
       .value = [](const ReadOuts& r) -> Value { return r.max_simultaneous; }},
      {.name = "msd_slope", .label = "msd_slope", .unit = "",
       .meaning = "log-log slope of the mean square displacement, lags of 10 min to half the run",
       .value = [](const ReadOuts& r) -> Value { return r.msd_slope; }, .usual = true,
       .least = -1e12},
      {.name = "path_angle_deg", .label = "path_angle", .unit = "degrees",
       .meaning = "mean angle of the path to uniaxial fibres, each step of 600 s weighted by its length",
       .value = [](const ReadOuts& r) -> Value { return r.guidance.path_angle; }, .of_fibres = true, .most = 90.0},
      {.name = "f_mat_along", .label = "f_mat_along", .unit = "-",
       .meaning = "maturation of protrusions along uniaxial fibres, mean",
       .value = [](const ReadOuts& r) -> Value { return r.along.f_mat.value; }, .of_fibres = true, .most = 1.0},
      {.name = "f_mat_across", .label = "f_mat_across", .unit = "-",
       .meaning = "maturation of protrusions across uniaxial fibres, mean",
       .value = [](const ReadOuts& r) -> Value { return r.across.f_mat.value; }, .of_fibres = true, .most = 1.0},
      {.name = "share_ruptured_along", .label = "share_ruptured_along", .unit = "",
       .meaning = "share of adhesions along uniaxial fibres that ended by rupture",
       .value = [](const ReadOuts& r) -> Value { return r.along.ruptured.value; }, .of_fibres = true, .most = 1.0},
      {.name = "share_ruptured_across", .label = "share_ruptured_across", .unit = "",
       .meaning = "share of adhesions across uniaxial fibres that ended by rupture",
       .value = [](const ReadOuts& r) -> Value { return r.across.ruptured.value; }, .of_fibres = true, .most = 1.0},
      {.name = "share_f_adh_rel_low", .label = "share_f_adh_rel_low", .unit = "",
       .meaning = "share of mature adhesions that ended below half of 2 f_mat F_am (both strands)",
       .value = [](const ReadOuts& r) -> Value { return r.share_low_force; }, .of_claims = true, .most = 1.0},
      {.name = "share_2_or_3_protrusions", .label = "share_2_or_3_protrusions", .unit = "",
       .meaning = "share of times with two or three protrusions",
       .value = [](const ReadOuts& r) -> Value { return r.share_2_or_3; }, .of_claims = true, .most = 1.0},
      {.name = "migration_index_x", .label = "migration_index_x", .unit = "",
       .meaning = "displacement along x over the length of the path, sampled every 600 s",
       .value = [](const ReadOuts& r) -> Value { return r.migration_index; }, .of_claims = true, .is_late = true,
       .least = -1.0, .most = 1.0},
      {.name = "step_angle_deg", .label = "step_angle", .unit = "degrees",
       .meaning = "mean angle of the path to uniaxial fibres, each step of 600 s counted alike",
       .value = [](const ReadOuts& r) -> Value { return r.guidance.step_angle; },
       .of_fibres = true, .is_late = true, .most = 90.0},
      {.name = "net_angle_deg", .label = "net_angle", .unit = "degrees",
       .meaning = "angle of the displacement from start to end to uniaxial fibres",
       .value = [](const ReadOuts& r) -> Value { return r.guidance.net_angle; },
       .of_fibres = true, .is_late = true, .most = 90.0},
      {.name = "along_over_across_1h", .label = "along_over_across_1h", .unit = "",
       .meaning = "mean square displacement along uniaxial fibres over that across them, in an hour",
       .value = [](const ReadOuts& r) -> Value { return r.guidance.ratios[0]; }, .of_fibres = true, .is_late = true},
      {.name = "along_over_across_3h", .label = "along_over_across_3h", .unit = "",
       .meaning = "mean square displacement along uniaxial fibres over that across them, in 3 h",
       .value = [](const ReadOuts& r) -> Value { return r.guidance.ratios[1]; }, .of_fibres = true, .is_late = true},
      {.name = "along_over_across_6h", .label = "along_over_across_6h", .unit = "",
       .meaning = "mean square displacement along uniaxial fibres over that across them, in 6 h",
       .value = [](const ReadOuts& r) -> Value { return r.guidance.ratios[2]; }, .of_fibres = true, .is_late = true},
      {.name = "parting_index", .label = "parting_index", .unit = "",
       .meaning = "cosine between displacement and the direction away from the nearest cell at the start",
       .value = [](const ReadOuts& r) -> Value { return r.parting_index; },
       .of_claims = true, .of_groups = true, .is_late = true, .least = -1.0, .most = 1.0},
      {.name = "share_in_contact", .label = "share_in_contact", .unit = "",
       .meaning = "share of times with a contact between cells",
       .value = [](const ReadOuts& r) -> Value { return r.share_in_contact; },
       .of_claims = true, .of_groups = true, .is_late = true, .most = 1.0},
      {.name = "nearest_um", .label = "nearest", .unit = "um", .meaning = "distance of the nearest other cell at the end, mean over cells",
       .value = [](const ReadOuts& r) -> Value { return r.nearest; },
       .of_claims = true, .of_groups = true, .is_late = true},
      {.name = "order", .label = "order", .unit = "",
       .meaning = "length of the mean unit vector of displacements over 10 min, mean over time",
       .value = [](const ReadOuts& r) -> Value { return r.order; },
       .of_claims = true, .of_groups = true, .is_late = true, .most = 1.0},
  }};
  // clang-format on
  return table;
}

const ReadOutSpec* find_readout(std::string_view name) {
  const auto found = std::ranges::find(readout_table(), name, &ReadOutSpec::name);
  return found == readout_table().end() ? nullptr : &*found;
}

} // namespace matrigrate
