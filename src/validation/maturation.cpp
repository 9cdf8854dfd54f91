#include "protrusion/maturation.hpp"
#include "parameters/presets.hpp"
#include "parameters/read.hpp"
#include "protrusion/adhesion.hpp"
#include "validation/case.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <utility>
#include <variant>

namespace matrigrate::validation {

namespace {

/// E [Pa] and f_mat of a single protrusion in an earlier, independent program, which had the second set of closures.
constexpr std::array<std::pair<double, double>, 4> expected{{{50, 0.29}, {100, 0.50}, {200, 0.89}, {400, 1.0}}};

/// Grows and matures one protrusion.
/// @param see  time since the adhesion [s], its force [nN] and the f_mat so far   @return its f_mat
double mature(const Parameters& p, const std::function<void(double, double, double)>& see) {
  const Laws laws(p);
  SingleProtrusion one(p, 0.0);
  one.march_for(p.protrusion.growth_time + 2.0 * p.run.time_step);
  const double begin = one.protrusion().record.t_adhesion;
  one.march_for(longest_maturation(p), {}, [&](const State& s) {
    const auto* maturing = std::get_if<Maturing>(&one.protrusion().phase);
    if (maturing == nullptr || s.step % 25 != 0) return true;
    see(s.t - begin, adhesion_force(one.cell().cortex, one.protrusion(), p.adhesion, laws),
        maturing_f_mat(maturing->steps, laws));
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
  for (const auto& [E, independent] : expected) {
    Parameters q = p;
    q.ecm.youngs_modulus = 1e-3 * E;
    report::Series force{.label = fmt::format("{:.0f} Pa", E)};
    f_mat.push_back(mature(q, [&, E = E](double t, double F, double so_far) {
      force.add(t, F);
      result.table.add({E, t, F, so_far});
    }));
    plot.series.push_back(std::move(force));
    const Parameters second = apply_overrides(q, find_preset("second-closures")->overrides);
    result.checks.push_back({fmt::format("f_mat at {:.0f} Pa with the second set of closures", E),
                             mature(second, [](double, double, double) {}), independent, 0.1,
                             "one step of maturation; by an independent program"});
  }
  for (std::size_t k = 1; k < f_mat.size(); ++k)
    result.checks.push_back(
        {fmt::format("rise of f_mat from {:.0f} to {:.0f} Pa", expected[k - 1].first, expected[k].first),
         f_mat[k] - f_mat[k - 1], f_mat[k - 1] < 1.0 ? 0.05 : 0.0, 0.0, "mechanosensing, up to the largest f_mat, 1",
         Sense::at_least});
  result.add("maturation", "A stiffer matrix resists more, and more steps are done in 600 s.", plot);
  return result;
}

} // namespace matrigrate::validation
