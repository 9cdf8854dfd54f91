#include "validation/cases.hpp"
#include "validation/collagen_data.hpp"
#include "validation/fibre_gels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::validation {

namespace {

constexpr double largest = 0.16;        // strain of the specimens
constexpr double compared_up_to = 0.15; // strain up to which errors are taken
constexpr int increments = 8;           // of the specimens
constexpr int fine = 64;                // of the infinite lattice
constexpr double rest_modulus = 0.01;   // Young's modulus of what is no fibre [kPa]

Parameters gel(Parameters p, double k_0) {
  p.ecm.youngs_modulus = rest_modulus;
  p.fibres.arrangement = FibreArrangement::isotropic;
  p.fibres.stiffness = k_0;
  return p;
}

/// Root-mean-square error of a curve relative to points up to compared_up_to.
double relative_error(const std::vector<Stretch>& curve, const std::vector<StressPoint>& points) {
  double sum = 0.0;
  int count = 0;
  for (const StressPoint& point : points) {
    if (point.strain > compared_up_to) continue;
    const double error = 1e3 * stress_at(curve, point.strain) / point.stress - 1.0;
    sum += error * error;
    ++count;
  }
  return std::sqrt(sum / count);
}

std::vector<StressPoint> semi_affine_curve(const Parameters& p, double k_0) {
  std::vector<StressPoint> points;
  for (double strain = 0.01; strain < compared_up_to + 0.005; strain += 0.01)
    points.push_back({strain, 1e3 * k_0 * semi_affine_stress(strain, p.fibres.onset, p.fibres.stiffening_strain)});
  return points;
}

/// Strain at which the curve of the infinite lattice leaves that of fibres that never stiffen.
double onset_of(const Parameters& p) {
  Parameters plain = p;
  plain.fibres.onset = 10.0;
  const std::vector<Stretch> stiffening = affine_lattice(p, largest, fine);
  const std::vector<Stretch> without = affine_lattice(plain, largest, fine);
  for (std::size_t k = 0; k < fine; ++k)
    if (stiffening[k].stress > 1.001 * without[k].stress) return stiffening[k].strain;
  return std::nan("");
}

/// Errors of the other readings of the law, on the infinite lattice.
std::string variants(const Parameters& p, const CollagenGel& gel_of) {
  std::string text = fmt::format("{} mg/ml, rms relative error to strain {} of the infinite lattice against the "
                                 "measured curve; the semi-affine law:",
                                 gel_of.concentration, compared_up_to);
  for (const FibreLaw law : {FibreLaw::tangent, FibreLaw::secant})
    for (const bool space : {false, true}) {
      Parameters q = gel(p, gel_of.k_0);
      q.fibres.law = law;
      q.fibres.plane_to_space = space;
      const std::vector<Stretch> curve = affine_lattice(q, largest, fine);
      text += fmt::format(" {}{} {:.2f}; {:.2f}.", law == FibreLaw::tangent ? "tangent" : "secant",
                          space ? " times 8/15" : "", relative_error(curve, gel_of.measured),
                          relative_error(curve, semi_affine_curve(p, gel_of.k_0)));
    }
  return text;
}

} // namespace

Result fibres(const Parameters& p) {
  Result result;
  result.table.columns = {"k_0_Pa",        "strain", "lateral_strain", "nominal_stress_Pa", "infinite_lattice_Pa",
                          "semi_affine_Pa"};
  io::Plot plot{.title = "Isotropic fibrillar gels of 0.6, 1.2 and 2.4 mg/ml",
                .x_label = "strain",
                .y_label = "nominal stress [Pa]",
                .log_y = true};
  int colour = 0;
  for (const CollagenGel& gel_of : collagen_gels()) {
    const Parameters q = gel(p, gel_of.k_0);
    const std::vector<Stretch> specimen = pull_specimen(q, largest * 1.1, increments);
    const std::vector<Stretch> lattice = affine_lattice(q, largest * 1.1, fine);
    const std::string name = fmt::format("{} mg/ml", gel_of.concentration);
    io::Series model{.label = name + ", model", .colour = colour};
    io::Series measured{.label = name + ", measured", .mark = io::Mark::points, .colour = colour};
    io::Series law{.label = name + ", semi-affine law", .mark = io::Mark::dashed, .colour = colour};
    for (const Stretch& s : specimen) {
      const double semi_affine =
          1e3 * gel_of.k_0 * semi_affine_stress(s.strain, p.fibres.onset, p.fibres.stiffening_strain);
      result.table.add({1e3 * gel_of.k_0, s.strain, s.lateral_strain, 1e3 * s.stress,
                        1e3 * stress_at(lattice, s.strain), semi_affine});
      model.x.push_back(s.strain);
      model.y.push_back(1e3 * s.stress);
      law.x.push_back(s.strain);
      law.y.push_back(semi_affine);
    }
    for (const StressPoint& point : gel_of.measured) {
      if (point.strain > largest) continue;
      measured.x.push_back(point.strain);
      measured.y.push_back(point.stress);
    }
    plot.series.insert(plot.series.end(), {model, measured, law});
    ++colour;
    const double at = 0.06;
    result.checks.push_back(
        {fmt::format("{}: stress of the specimen over that of the infinite lattice at {}", name, at),
         stress_at(specimen, at) / stress_at(lattice, at), 1.0, edge_error(p.ecm),
         "free edges known to a spacing each"});
    result.checks.push_back({fmt::format("{}: strain at which stiffening sets in", name), onset_of(q), p.fibres.onset,
                             2.0 * largest / fine, "two increments of the infinite lattice"});
    result.remarks.push_back(fmt::format("{}: rms relative error of the specimen to strain {}: {:.2f} against the "
                                         "measured curve, {:.2f} against the semi-affine law.",
                                         name, compared_up_to, relative_error(specimen, gel_of.measured),
                                         relative_error(specimen, semi_affine_curve(p, gel_of.k_0))));
    result.remarks.push_back(variants(p, gel_of));
  }
  result.figures.push_back(
      {"fibres", "Uniaxial stretch with free sides, quasi-static, against measured gels and the law fitted to them.",
       io::to_svg(plot, 720, 560)});
  return result;
}

} // namespace matrigrate::validation
