#include "validation/case.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace matrigrate::validation {

namespace {

constexpr double longest_growth = 600.0;                 // [s]
constexpr std::array<double, 3> times{200, 400, 600};    // T_prot of the paper's Fig 8 [s]
constexpr std::array<double, 3> stiffness{50, 200, 400}; // [Pa]
constexpr double longest_in_paper = 30.0;                // [um]

/// Length over time of a protrusion that grows for longest_growth.
report::Series grow(Parameters p, double angle, store::Table& table) {
  p.protrusion.growth_time = 2.0 * longest_growth;
  SingleProtrusion one(p, angle);
  const double E = 1e3 * p.ecm.youngs_modulus, degrees = angle * 180.0 / std::numbers::pi;
  report::Series series{.label = fmt::format("{:.0f} Pa, {:.1f} degrees", E, degrees)};
  for (double t = 20.0; t < longest_growth + 1.0; t += 20.0) {
    one.march_for(20.0);
    series.add(t, one.length());
    table.add({E, degrees, t, one.length()});
  }
  return series;
}

double length_at(const report::Series& series, double t) {
  for (std::size_t k = 0; k < series.x.size(); ++k)
    if (std::abs(series.x[k] - t) < 1.0) return series.y[k];
  return std::nan("");
}

} // namespace

Result protrusion(const Parameters& p) {
  Result result;
  result.table.columns = {"E_Pa", "angle_deg", "time_s", "length_um"};
  report::Plot plot{.title = "Growth of the first protrusion", .x_label = "time (s)", .y_label = "length (µm)"};
  Parameters q = p;
  for (const double E : stiffness) {
    q.ecm.youngs_modulus = 1e-3 * E;
    plot.series.push_back(grow(q, 0.0, result.table));
  }
  for (const double angle : {std::numbers::pi / 8.0, std::numbers::pi / 4.0})
    plot.series.push_back(grow(p, angle, result.table));
  const report::Series& soft = plot.series[0];
  const report::Series& base = plot.series[1];
  const report::Series& stiff = plot.series[2];

  const double mean =
      (length_at(base, times[1]) + length_at(plot.series[3], times[1]) + length_at(plot.series[4], times[1])) / 3.0;
  result.checks.push_back({"length after 400 s, mean of three directions on the lattice (µm)", mean, 25.0, 0.0,
                           "the lower end of the paper's 25 to 30 µm", Sense::at_least});
  if (mean > longest_in_paper)
    result.remarks.push_back(fmt::format("A first protrusion of {:.1f} µm is longer than the paper's 25 to 30 µm, "
                                         "which are means over all protrusions of six-hour runs.",
                                         mean));
  result.checks.push_back({"length after 200 s over a third of that after 600 s",
                           length_at(base, times[0]) / (length_at(base, times[2]) / 3.0), 1.0, 0.0,
                           "grows less than proportionally with T_prot", Sense::at_least});
  result.checks.push_back({"length after 400 s at 400 Pa over that at 50 Pa",
                           length_at(stiff, times[1]) / length_at(soft, times[1]), 1.0, 0.1,
                           "the paper's l_prot is only slightly lower with stiffness"});
  result.add("protrusion", "A protrusion slows down as its flanks lengthen; stiffness hardly matters.", plot);
  return result;
}

} // namespace matrigrate::validation
