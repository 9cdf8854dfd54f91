#include "cell/geometry.hpp"
#include "protrusion/adhesion.hpp"
#include "protrusion/maturation.hpp"
#include "simulation/start.hpp"
#include "validation/case.hpp"
#include "validation/single_protrusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <variant>

namespace matrigrate::validation {

namespace {

constexpr double alone = 600.0;    // for which the first ones hold each other before one more begins [s]
constexpr double followed = 300.0; // the end of that time, in which their rate is measured [s]

struct Arrangement {
  std::string name;
  std::vector<double> first; // directions of the protrusions that begin at t = 0 [rad]
  double later;              // of the one that begins when they hold each other [rad]
};

/// Mean of r_off over r_off_min of each adhesion, over a span of time.
class MeanRate {
public:
  MeanRate(std::size_t n, const AdhesionParameters& p) : m_sum(n), m_p(p) {}

  void add(const Cell& cell) {
    for (std::size_t k = 0; k < m_sum.size(); ++k) {
      const auto* phase = std::get_if<Contracting>(&cell.protrusions[k].phase);
      const double F =
          phase != nullptr ? adhesion_force(cell.cortex, cell.protrusions[k], m_p) : 0.0; // none: as if not loaded
      m_sum[k] += disassembly_rate(F, phase != nullptr ? phase->f_mat : 1.0, m_p) / m_p.r_off_min;
    }
    ++m_count;
  }

  double largest() const { return std::ranges::max(m_sum) / static_cast<double>(std::max(m_count, 1)); }

private:
  std::vector<double> m_sum;
  int m_count = 0;
  AdhesionParameters m_p;
};

/// What one arrangement gave.
struct Outcome {
  double while_held = 0.0;                 // largest mean r_off over r_off_min of an adhesion while none grows [-]
  double while_grown = 0.0;                // the same while one more grows [-]
  double base_start = 0.0, base_end = 0.0; // width of the base of the one that grows [um]
  double length = 0.0;                     // of it, at the end of growth [um]
  double area = 0.0;                       // largest area of the cell over A_0 [-]
};

void record(const PlacedProtrusions& cell, const AdhesionParameters& p, int number, store::Table& table,
            report::Plot& plot) {
  const double t = cell.state().t;
  const std::vector<Protrusion>& protrusions = cell.cell().protrusions;
  for (std::size_t k = 0; k < protrusions.size(); ++k) {
    const auto* phase = std::get_if<Contracting>(&protrusions[k].phase);
    const double F = adhesion_force(cell.cell().cortex, protrusions[k], p);
    table.add({static_cast<double>(number), static_cast<double>(k + 1), t, F, phase ? phase->f_mat : 0.0,
               cell.base_width(k), cell.slack(k)});
    plot.series[k].x.push_back(t);
    plot.series[k].y.push_back(F);
  }
}

Outcome compete(const Parameters& p, const Arrangement& arrangement, store::Table& table, report::Plot& plot) {
  PlacedProtrusions cell(p, Vec2::Zero());
  for (const double angle : arrangement.first) cell.begin(angle);
  const std::size_t n = arrangement.first.size();
  const auto number = static_cast<int>(n);
  for (std::size_t k = 0; k <= n; ++k)
    plot.series.push_back({.label = k < n ? fmt::format("adhesion {}", k + 1) : "the one that comes later"});
  Outcome out;
  const auto follow = [&](double seconds, MeanRate* rate) {
    cell.march_for(seconds, [&](const State& s) {
      if (rate != nullptr) rate->add(s.cells.front());
      out.area = std::max(out.area, area(s.cells.front().cortex) / initial_area(p.cell));
      if (s.step % 10 == 0) record(cell, p.adhesion, number, table, plot);
      return true;
    });
  };
  const double matured = p.protrusion.growth_time + longest_maturation(p);
  follow(matured + alone - followed, nullptr);
  MeanRate held(n, p.adhesion), grown(n, p.adhesion);
  follow(followed, &held);
  cell.begin(arrangement.later);
  out.base_start = cell.base_width(n);
  follow(p.protrusion.growth_time, &grown);
  out.base_end = cell.base_width(n);
  out.length = cell.length(n);
  follow(p.adhesion.maturation_time + alone, nullptr);
  out.while_held = held.largest();
  out.while_grown = grown.largest();
  return out;
}

} // namespace

Result competition(const Parameters& p) {
  Result result;
  result.table.columns = {"held", "protrusion", "time_s", "force_nN", "f_mat", "base_width_um", "slack"};
  const std::vector<Arrangement> arrangements{
      {"two opposed", {0.0, std::numbers::pi}, 0.5 * std::numbers::pi},
      {"three", {0.0, 0.5 * std::numbers::pi, std::numbers::pi}, 1.5 * std::numbers::pi}};
  for (const Arrangement& arrangement : arrangements) {
    report::Plot plot{.title = fmt::format("Adhesions of a cell: {} mature, then one more", arrangement.name),
                      .x_label = "time (s)",
                      .y_label = "force of the adhesion (nN)"};
    const Outcome out = compete(p, arrangement, result.table, plot);
    const std::string& name = arrangement.name;
    result.checks.push_back({fmt::format("{}: mean r_off over r_off_min while none grows", name), out.while_held, 1.5,
                             0.0, "competing protrusions stabilize each other in the paper", Sense::at_most});
    result.checks.push_back({fmt::format("{}: mean r_off over r_off_min while one more grows", name), out.while_grown,
                             1.5, 0.0, "the ring is closed at a growing protrusion", Sense::at_most});
    result.checks.push_back({fmt::format("{}: base of the growing one, end over start", name),
                             out.base_end / out.base_start, 1.5, 0.0, "neighbours do not pull it open",
                             Sense::at_most});
    result.remarks.push_back(
        fmt::format("{}: the one that grew later became {:.1f} µm long; its base went from {:.1f} to {:.1f} µm; the "
                    "largest area of the cell was {:.2f} A_0.",
                    name, out.length, out.base_start, out.base_end, out.area));
    result.add(result.plots.empty() ? "competition" : "three",
               "Adhesions hold each other; one more protrusion grows, matures and joins them.", plot);
  }
  return result;
}

} // namespace matrigrate::validation
