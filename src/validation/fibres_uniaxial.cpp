#include "validation/cases.hpp"
#include "validation/fibre_gels.hpp"

#include <fmt/format.h>

#include <string>

namespace matrigrate::validation {

namespace {

constexpr double largest = 0.16;
constexpr int increments = 16;
constexpr int fine = 160;
constexpr double densest_k_0 = 5.208; // of the isotropic gel of 2.4 mg/ml [kPa]

Parameters gel(Parameters p, double direction_deg) {
  p.ecm.youngs_modulus = 0.01;
  p.fibres.arrangement = FibreArrangement::uniaxial;
  p.fibres.stiffness = 10.0;
  p.fibres.direction_deg = direction_deg;
  return p;
}

} // namespace

Result fibres_uniaxial(const Parameters& p) {
  Result result;
  result.table.columns = {"angle_to_fibres_deg", "strain", "nominal_stress_Pa", "infinite_lattice_Pa"};
  io::Plot plot{.title = "Uniaxial fibrillar gel, stretched along and across its fibres",
                .x_label = "strain",
                .y_label = "nominal stress [Pa]",
                .log_y = true};
  std::vector<std::vector<Stretch>> specimens;
  for (const double angle : {0.0, 90.0}) {
    const Parameters q = gel(p, angle);
    const std::vector<Stretch> specimen = pull_strip(q, largest, increments);
    const std::vector<Stretch> lattice = affine_lattice(q, largest * 1.01, fine, Sides::held);
    io::Series series{.label = angle == 0.0 ? "along" : "across"};
    for (const Stretch& s : specimen) {
      result.table.add({angle, s.strain, 1e3 * s.stress, 1e3 * stress_at(lattice, s.strain)});
      series.x.push_back(s.strain);
      series.y.push_back(1e3 * s.stress);
    }
    plot.series.push_back(series);
    result.checks.push_back(
        {fmt::format("{}: stress of the specimen over that of the infinite lattice at 0.06", series.label),
         stress_at(specimen, 0.06) / stress_at(lattice, 0.06), 1.0, 0.01,
         "both are homogeneous: steps in time, and the end of relaxation"});
    specimens.push_back(specimen);
  }
  Parameters densest = gel(p, 0.0);
  densest.fibres.arrangement = FibreArrangement::isotropic;
  densest.fibres.stiffness = densest_k_0;
  const std::vector<Stretch> isotropic = affine_lattice(densest, largest * 1.01, fine, Sides::held);
  io::Series dense{.label = "isotropic, 2.4 mg/ml", .mark = io::Mark::dashed};
  for (const Stretch& s : isotropic) {
    if (s.strain > largest) continue;
    dense.x.push_back(s.strain);
    dense.y.push_back(1e3 * s.stress);
  }
  plot.series.push_back(dense);
  for (const double strain : {0.05, 0.1}) {
    const double ratio = stress_at(specimens[0], strain) / stress_at(isotropic, strain);
    result.claims.push_back({fmt::format("stress along over that of the isotropic gel of 2.4 mg/ml at {} [-]", strain),
                             ratio, 1.5, 0.5, "the paper's Fig 2D: somewhat stiffer along; between once and twice"});
    result.claims.push_back({fmt::format("stress along over stress across at {} [-]", strain),
                             stress_at(specimens[0], strain) / stress_at(specimens[1], strain), 10.0, 0.0,
                             "the paper's Fig 2D: very soft across", Sense::at_least});
  }
  result.figures.push_back(
      {"fibres-uniaxial", "Quasi-static stretch with held sides; k_0 = 10 kPa, 30 degrees.", io::to_svg(plot)});
  return result;
}

} // namespace matrigrate::validation
