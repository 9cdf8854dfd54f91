#include "validation/case.hpp"
#include "validation/fibre_gels.hpp"

#include <fmt/format.h>

#include <string>

namespace matrigrate::validation {

namespace {

constexpr double densest_k_0 = 5.208; // of the isotropic gel of 2.4 mg/ml [kPa]

Parameters parallel_gel(Parameters p, double direction_deg) {
  p.ecm.youngs_modulus = 0.01;
  p.fibres.arrangement = FibreArrangement::uniaxial;
  p.fibres.stiffness = 10.0;
  p.fibres.direction_deg = direction_deg;
  return p;
}

} // namespace

Result fibres_uniaxial(const Parameters& p) {
  Result result;
  result.table.columns = {"angle_to_fibres_deg", "strain", "nominal_stress_Pa", "infinite_lattice_Pa",
                          "isotropic_gel_Pa"};
  Parameters densest = parallel_gel(p, 0.0);
  densest.fibres.arrangement = FibreArrangement::isotropic;
  densest.fibres.stiffness = densest_k_0;
  const std::vector<Stretch> isotropic =
      affine_lattice(densest, largest_strain * 1.01, lattice_increments, Sides::held);
  std::vector<std::vector<Stretch>> specimens;
  for (const double angle : {0.0, 90.0}) {
    const Parameters q = parallel_gel(p, angle);
    const std::vector<Stretch> specimen = pull_strip(q, largest_strain, strip_increments);
    const std::vector<Stretch> lattice = affine_lattice(q, largest_strain * 1.01, lattice_increments, Sides::held);
    for (const Stretch& s : specimen)
      result.table.add(
          {angle, s.strain, 1e3 * s.stress, 1e3 * stress_at(lattice, s.strain), 1e3 * stress_at(isotropic, s.strain)});
    result.checks.push_back(
        {fmt::format("{}: stress of the specimen over the infinite lattice at 0.06", angle == 0.0 ? "along" : "across"),
         stress_at(specimen, 0.06) / stress_at(lattice, 0.06), 1.0, 0.01,
         "both are homogeneous: steps in time, and the end of relaxation"});
    specimens.push_back(specimen);
  }
  for (const double strain : {0.05, 0.1}) {
    const double ratio = stress_at(specimens[0], strain) / stress_at(isotropic, strain);
    result.claims.push_back({fmt::format("stress along over the isotropic gel of 2.4 mg/ml at {}", strain), ratio, 1.5,
                             0.5, "the paper's Fig 2D: somewhat stiffer along; between once and twice"});
    result.claims.push_back({fmt::format("stress along over stress across at {}", strain),
                             stress_at(specimens[0], strain) / stress_at(specimens[1], strain), 10.0, 0.0,
                             "the paper's Fig 2D: very soft across", Sense::at_least});
  }
  return result;
}

report::Plot plot_fibres_uniaxial(const store::Table& table) {
  report::Plot plot{.name = "fibres-uniaxial",
                    .title = "Uniaxial fibrillar gel, stretched along and across its fibres",
                    .caption = "Quasi-static stretch with held sides; k_0 = 10 kPa, 30 degrees.",
                    .x_label = "strain",
                    .y_label = "nominal stress (Pa)",
                    .log_y = true};
  for (const auto& [angle, rows] : table.by_first_column()) {
    plot.series.push_back({.label = angle == 0.0 ? "along" : "across"});
    plot.series.back().x = rows.column("strain");
    plot.series.back().y = rows.column("nominal_stress_Pa");
  }
  plot.series.push_back({.label = "isotropic, 2.4 mg/ml", .mark = report::Mark::dashed});
  plot.series.back().x = plot.series.front().x;
  plot.series.back().y = table.by_first_column().front().second.column("isotropic_gel_Pa");
  return plot;
}

} // namespace matrigrate::validation
