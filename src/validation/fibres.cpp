#include "base/failure.hpp"
#include "validation/case.hpp"
#include "validation/collagen_data.hpp"
#include "validation/fibre_gels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace matrigrate::validation {

namespace {

constexpr double judged_up_to = 0.10; // strain
constexpr double data_up_to = 0.15;   // strain
constexpr double agreement = 0.15;    // largest rms relative error that is called agreement
constexpr double rest_modulus = 0.01; // Young's modulus of what is no fibre [kPa]

Parameters gel(Parameters p, double k_0) {
  p.ecm.youngs_modulus = rest_modulus;
  p.fibres.arrangement = FibreArrangement::isotropic;
  p.fibres.stiffness = k_0;
  return p;
}

/// Root-mean-square error of a curve relative to points up to a strain.
double relative_error(const std::vector<Stretch>& curve, const std::vector<StressPoint>& points, double up_to) {
  double sum = 0.0;
  int count = 0;
  for (const StressPoint& point : points) {
    if (point.strain > up_to + 1e-9) continue;
    const double error = 1e3 * stress_at(curve, point.strain) / point.stress - 1.0;
    sum += error * error;
    ++count;
  }
  return std::sqrt(sum / count);
}

/// The semi-affine law in steps of 0.01.
std::vector<StressPoint> law_curve(const Parameters& p, double k_0, Sides sides) {
  std::vector<StressPoint> points;
  for (int k = 1; k <= strip_increments; ++k) {
    const double strain = 0.01 * k;
    points.push_back(
        {strain, 1e3 * k_0 * semi_affine_stress(strain, p.fibres.onset, p.fibres.stiffening_strain, sides)});
  }
  return points;
}

/// Strain at which the curve of the infinite lattice leaves that of fibres that never stiffen.
double onset_of(const Parameters& p) {
  Parameters plain = p;
  plain.fibres.onset = 10.0;
  const std::vector<Stretch> stiffening = affine_lattice(p, largest_strain, lattice_increments, Sides::held);
  const std::vector<Stretch> without = affine_lattice(plain, largest_strain, lattice_increments, Sides::held);
  for (std::size_t k = 0; k < lattice_increments; ++k)
    if (stiffening[k].stress > 1.0001 * without[k].stress) return stiffening[k].strain;
  return std::nan("");
}

/// Error of the infinite lattice against the semi-affine law, both with the same sides.
double law_error(const Parameters& p, Sides sides) {
  return relative_error(affine_lattice(p, largest_strain * 1.01, lattice_increments, sides),
                        law_curve(p, p.fibres.stiffness, sides), judged_up_to);
}

Parameters without_rest(Parameters p) {
  p.ecm.youngs_modulus = 1e-9;
  return p;
}

/// Errors of other specimens.
std::string of_other_specimens(const Parameters& p, const CollagenGel& gel_of) {
  const Parameters q = gel(p, gel_of.k_0);
  std::string text = fmt::format("{} mg/ml, rms relative error of the infinite lattice to strain {:.2f}: {:.2f},",
                                 gel_of.concentration, judged_up_to, law_error(q, Sides::held));
  text += fmt::format(" with free sides of lattice and law {:.2f},", law_error(q, Sides::free));
  return text + fmt::format(" without the elastic rest {:.2f}.", law_error(without_rest(q), Sides::held));
}

bool near(double a, double b) { return std::abs(a - b) < 1e-6 * b; }

} // namespace

Result fibres(const Parameters& p) {
  Result result;
  result.table.columns = {"k_0_Pa", "strain", "nominal_stress_Pa", "infinite_lattice_Pa", "semi_affine_Pa"};
  for (const CollagenGel& gel_of : collagen_gels()) {
    const Parameters q = gel(p, gel_of.k_0);
    const std::vector<Stretch> specimen = pull_strip(q, largest_strain, strip_increments);
    const std::vector<Stretch> lattice = affine_lattice(q, largest_strain * 1.01, lattice_increments, Sides::held);
    const std::vector<StressPoint> law_points = law_curve(p, gel_of.k_0, Sides::held);
    const std::string name = fmt::format("{} mg/ml", gel_of.concentration);
    for (std::size_t k = 0; k < specimen.size(); ++k) {
      const Stretch& s = specimen[k];
      result.table.add(
          {1e3 * gel_of.k_0, s.strain, 1e3 * s.stress, 1e3 * stress_at(lattice, s.strain), law_points[k].stress});
    }
    for (const double at : {0.06, 0.12})
      result.checks.push_back({fmt::format("{}: stress of the specimen over the infinite lattice at {}", name, at),
                               stress_at(specimen, at) / stress_at(lattice, at), 1.0, 0.01,
                               "both are homogeneous: steps in time, and the end of relaxation"});
    result.checks.push_back({fmt::format("{}: strain at which stiffening sets in", name), onset_of(q), p.fibres.onset,
                             2.0 * largest_strain / lattice_increments, "two increments of the infinite lattice"});
    const double error = relative_error(specimen, law_points, judged_up_to);
    const double from_data = relative_error(specimen, gel_of.measured, data_up_to);
    if (gel_of.concentration > 1.0)
      result.claims.push_back({fmt::format("{}: rms relative error of the stress to strain {:.2f} against the "
                                           "semi-affine law, sides held in both (to the measured curve: {:.2f} to "
                                           "strain {:.2f}, not judged)",
                                           name, judged_up_to, from_data, data_up_to),
                               error, agreement, 0.0, "what agreement is taken to mean here", Sense::at_most});
    result.claim_notes.push_back(
        fmt::format("{}: rms relative error {:.2f} to strain {:.2f} against the measured curve, "
                    "whose source labels it shear.",
                    name, from_data, data_up_to));
    if (gel_of.concentration < 1.0)
      result.claim_notes.push_back(fmt::format(
          "{} is not judged: rms relative error {:.2f} against the law, and {:.2f} without the elastic rest of "
          "10 Pa, which the law does not have and which is a good part of so soft a gel's stress.",
          name, error, law_error(without_rest(q), Sides::held)));
    result.remarks.push_back(of_other_specimens(p, gel_of));
  }
  return result;
}

report::Plot plot_fibres(const store::Table& table) {
  report::Plot plot{
      .name = "fibres",
      .title = "Isotropic fibrillar gels of 0.6, 1.2 and 2.4 mg/ml",
      .caption = "Uniaxial stretch with held sides, quasi-static, against measured gels and the semi-affine law.",
      .x_label = "strain",
      .y_label = "nominal stress (Pa)",
      .log_y = true};
  int colour = 0;
  for (const auto& [k_0, rows] : table.by_first_column()) {
    const std::vector<CollagenGel> gels = collagen_gels();
    const auto gel_of = std::ranges::find_if(gels, [k = k_0](const CollagenGel& g) { return near(1e3 * g.k_0, k); });
    if (gel_of == gels.end()) throw InputOutputError(fmt::format("no gel of k_0 = {} Pa is known", k_0));
    const std::string name = fmt::format("{} mg/ml", gel_of->concentration);
    const std::vector<double> strain = rows.column("strain");
    report::Series model{.label = name + ", model", .colour = colour};
    report::Series measured{.label = name + ", measured", .mark = report::Mark::points, .colour = colour};
    report::Series law{.label = name + ", semi-affine law", .mark = report::Mark::dashed, .colour = colour++};
    model.x = law.x = strain;
    model.y = rows.column("nominal_stress_Pa");
    law.y = rows.column("semi_affine_Pa");
    for (const StressPoint& point : gel_of->measured) {
      if (point.strain > largest_strain) continue;
      measured.x.push_back(point.strain);
      measured.y.push_back(point.stress);
    }
    plot.series.insert(plot.series.end(), {model, measured, law});
  }
  return plot;
}

} // namespace matrigrate::validation
