#include "protrusion/maturation.hpp"
#include "protrusion/adhesion.hpp"
#include "validation/case.hpp"
#include "validation/single_protrusion.hpp"

#include <fmt/format.h>

#include <array>
#include <variant>

namespace matrigrate::validation {

namespace {

struct Expected {
  double E;     // [Pa]
  double f_mat; // [-]
};

/// A single protrusion in an earlier, independent program with the same closures.
constexpr std::array<Expected, 4> expected{{{50, 0.29}, {100, 0.50}, {200, 0.89}, {400, 1.0}}};

/// Grows and matures one protrusion.   @return its maturation, and the force of its adhesion over time
double mature(const Parameters& p, report::Series& force, store::Table& table) {
  SingleProtrusion one(p, 0.0);
  one.march_for(p.protrusion.growth_time + 2.0 * p.run.time_step);
  const double begin = one.protrusion().record.t_adhesion;
  one.march_for(longest_maturation(p), [&](const State& s) {
    const auto* maturing = std::get_if<Maturing>(&one.protrusion().phase);
    if (maturing == nullptr || s.step % 25 != 0) return true;
    const double F = adhesion_force(one.cell().cortex, one.protrusion(), p.adhesion);
    force.x.push_back(s.t - begin);
    force.y.push_back(F);
    table.add({1e3 * p.ecm.youngs_modulus, s.t - begin, F, maturing_f_mat(maturing->steps)});
    return true;
  });
  return one.protrusion().record.f_mat;
}

} // namespace

Result maturation(const Parameters& p) {
  Result result;
  result.table.columns = {"E_Pa", "time_s", "force_nN", "running_f_mat"};
  report::Plot plot{.title = "Maturation against the stiffness of the matrix",
                    .x_label = "time since adhesion (s)",
                    .y_label = "force of the adhesion (nN)"};
  std::vector<double> f_mat;
  for (const Expected& row : expected) {
    Parameters q = p;
    q.ecm.youngs_modulus = 1e-3 * row.E;
    plot.series.push_back({.label = fmt::format("{:.0f} Pa", row.E)});
    f_mat.push_back(mature(q, plot.series.back(), result.table));
    result.checks.push_back(
        {fmt::format("f_mat at {:.0f} Pa", row.E), f_mat.back(), row.f_mat, maturation_step, "one step of maturation"});
  }
  for (std::size_t k = 1; k < f_mat.size(); ++k)
    result.checks.push_back({fmt::format("rise of f_mat from {:.0f} to {:.0f} Pa", expected[k - 1].E, expected[k].E),
                             f_mat[k] - f_mat[k - 1], 0.05, 0.0, "mechanosensing: still rising to 400 Pa in the paper",
                             Sense::at_least});
  result.add("maturation", "A stiffer matrix resists more, and more steps are done in 600 s.", plot);
  return result;
}

} // namespace matrigrate::validation
