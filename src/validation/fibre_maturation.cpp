#include "ecm/loop/fibres.hpp"
#include "protrusion/adhesion.hpp"
#include "protrusion/maturation.hpp"
#include "state/dof.hpp"
#include "validation/case.hpp"
#include "validation/single_protrusion.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

namespace matrigrate::validation {

namespace {

constexpr double pushed_for = 1800.0; // [s]
constexpr double ahead = 15.0;        // of the tip: fibres that are looked at [um]

struct Matured {
  double f_mat = 0.0; // [-]
  double slack = 0.0; // share of the fibres ahead of the tip that are shorter than at rest, at the end of growth [-]
};

/// Share of the fibres around the site of adhesion that are shorter than in the reference configuration.
double share_slack(const EcmState& ecm, const FibreNetwork& network, const Vec2& place) {
  int all = 0, slack = 0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.f[i] <= 0.0 || (ecm.x[i] - place).norm() > ahead) continue;
    for (std::uint32_t k = network.pairs().first[i]; k < network.pairs().first[i + 1]; ++k) {
      const std::uint32_t j = network.pairs().index[k];
      if (ecm.f[j] <= 0.0) continue;
      ++all;
      if ((ecm.x[i] - ecm.x[j]).norm() < network.length(k)) ++slack;
    }
  }
  return all > 0 ? static_cast<double>(slack) / all : 0.0;
}

/// A protrusion at an angle to the fibres, in fresh gel or where its cell has been pushed before, with F_am in all.
Matured mature(const Parameters& p, double angle_deg, bool pushed) {
  Parameters q = p;
  q.run.integrator = Integrator::adaptive;
  q.run.time_step = usual_time_step(q.run.integrator);
  q.fibres.direction_deg = 0.0;
  const double angle = angle_deg * std::numbers::pi / 180.0;
  const Vec2 direction(std::cos(angle), std::sin(angle));
  PlacedProtrusions cell(q, -20.0 * direction);
  if (pushed)
    cell.march_for(pushed_for, {}, [&](const State& s, std::span<Vec2> force) {
      const std::size_t n = s.cells.front().cortex.size();
      const std::size_t first = first_node(s, 0);
      for (std::size_t i = 0; i < n; ++i) force[first + i] += q.actomyosin.force / static_cast<double>(n) * direction;
    });
  cell.begin(angle);
  cell.march_for(q.protrusion.growth_time + q.run.time_step);
  const Protrusion& protrusion = cell.cell().protrusions.front();
  Matured result;
  const auto* maturing = std::get_if<Maturing>(&protrusion.phase);
  if (maturing == nullptr) return result; // no solid ahead
  const EcmState& ecm = cell.state().ecm;
  result.slack = share_slack(ecm, FibreNetwork(ecm, q.ecm, q.fibres, Reference(ecm, q.ecm)), maturing->anchor);
  cell.march_for(longest_maturation(q));
  result.f_mat = cell.cell().protrusions.front().record.f_mat;
  return result;
}

} // namespace

Result fibre_maturation(const Parameters& p) {
  Result result;
  result.table.columns = {"poissons_ratio", "pushed", "angle_deg", "f_mat", "share_slack"};
  report::Plot plot{.title = "Maturation among parallel fibres",
                    .x_label = "angle to the fibres (degrees)",
                    .y_label = "maturation, f_mat"};
  Parameters q = p;
  q.fibres.arrangement = FibreArrangement::uniaxial;
  q.fibres.stiffness = 10.0;
  q.ecm.youngs_modulus = 0.01;
  struct Setting {
    double nu; // Poisson's ratio of the matrix between the fibres [-]
    bool pushed;
  };
  // 0.4975: between the fibres the bulk modulus of the matrix of 200 Pa
  constexpr std::array settings{Setting{0.45, false}, Setting{0.45, true}, Setting{0.4975, false},
                                Setting{0.4975, true}};
  for (const auto& [nu, pushed] : settings) {
    q.ecm.poissons_ratio = nu;
    report::Series series{
        .label = fmt::format("Poisson's ratio {}, {}", nu, pushed ? "after half an hour of pushing" : "fresh")};
    std::string found_text;
    for (const double angle : nu == 0.45 ? std::vector{0.0, 30.0, 60.0, 90.0} : std::vector{0.0, 90.0}) {
      const Matured found = mature(q, angle, pushed);
      series.x.push_back(angle);
      series.y.push_back(found.f_mat);
      found_text += fmt::format("{}f_mat {:.2f} at {:.0f} degrees, where {:.0f} % of the fibres ahead are slack",
                                found_text.empty() ? "" : "; ", found.f_mat, angle, 100.0 * found.slack);
      result.table.add({nu, pushed ? 1.0 : 0.0, angle, found.f_mat, found.slack});
    }
    found_text += ".";
    const double contrast = series.y.front() / series.y.back();
    if (nu == 0.45 && !pushed)
      result.checks.push_back({"f_mat along less that across the fibres, fresh gel", series.y.front() - series.y.back(),
                               0.3, 0.0, "three steps of maturation: the gel is five times as stiff along its fibres",
                               Sense::at_least});
    result.claims.push_back({"f_mat along over across the fibres, " + series.label, contrast, 3.0, 0.0,
                             "protrusions across the fibres are the weak ones (Fig 13)", Sense::at_least});
    result.remarks.push_back(series.label + ": " + found_text);
    plot.series.push_back(std::move(series));
  }
  result.add("fibre-maturation", "A protrusion along the fibres meets a stiff matrix, one across them a soft one.",
             plot);
  return result;
}

} // namespace matrigrate::validation
