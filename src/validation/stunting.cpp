#include "cell/geometry.hpp"
#include "sph/interpolate.hpp"
#include "validation/case.hpp"
#include "validation/single_protrusion.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <variant>

namespace matrigrate::validation {

namespace {

constexpr double start = 20.0;            // of the cell left of the centre of the disc [um]
constexpr double tunnel_half_width = 2.5; // of an old tunnel [um]
constexpr double degree = std::numbers::pi / 180.0;

struct Outcome {
  report::Series length, base; // over time [um]
  double slack = 0.0;          // of the contour at the end of growth [-]
  bool adheres = false;
};

Outcome grow(PlacedProtrusions& cell, double condition, double value, store::Table& table) {
  Outcome out;
  const Parameters& p = cell.parameters();
  const auto note = [&] {
    out.length.x.push_back(cell.state().t);
    out.length.y.push_back(cell.length(0));
    out.base.x.push_back(cell.state().t);
    out.base.y.push_back(cell.base_width(0));
    table.add({condition, value, cell.state().t, cell.length(0), cell.base_width(0), cell.slack(0)});
  };
  note();
  cell.march_for(p.protrusion.growth_time - p.run.time_step, [&](const State& s) {
    if (s.step % 10 == 0) note();
    return true;
  });
  note();
  out.slack = cell.slack(0);
  cell.march_for(3.0 * p.run.time_step);
  out.adheres = std::holds_alternative<Maturing>(cell.cell().protrusions.front().phase);
  return out;
}

} // namespace

Result stunting(const Parameters& p) {
  Result result;
  result.table.columns = {"beside_tunnel", "tilt_deg_or_distance_um", "time_s", "length_um", "base_width_um", "slack"};
  report::Plot tilted{.title = "Growth askew", .x_label = "time (s)", .y_label = "length of the protrusion (µm)"};
  for (const double tilt : {0.0, 20.0, 40.0, 60.0}) {
    PlacedProtrusions cell(p, Vec2(-start, 0.0));
    cell.begin(0.0, tilt * degree);
    Outcome out = grow(cell, 0.0, tilt, result.table);
    out.length.label = fmt::format("{:.0f} degrees", tilt);
    const double length = out.length.y.back();
    if (tilt == 0.0) {
      result.checks.push_back({"length of a straight protrusion (µm)", length, 27.5, 5.0,
                               "the paper's 25 to 30 µm are means over whole runs"});
      result.checks.push_back({"its base, end of growth over start", out.base.y.back() / out.base.y.front(), 1.0, 0.2,
                               "the neighbouring cortex does not slide into it"});
    }
    if (tilt > 0.0)
      result.checks.push_back({fmt::format("length {:.0f} degrees askew (µm)", tilt), length, 20.0, 0.0,
                               "no dwarf of under 12 µm by tilt alone", Sense::at_least});
    result.remarks.push_back(fmt::format("{:.0f} degrees off the normal: {:.1f} µm, base {:.1f} µm, slack {:.2f}.",
                                         tilt, length, out.base.y.back(), out.slack));
    tilted.series.push_back(std::move(out.length));
  }
  report::Plot beside{
      .title = "Growth beside an old tunnel", .x_label = "time (s)", .y_label = "length of the protrusion (µm)"};
  for (const double distance : {0.0, 3.0, 6.0, 12.0}) {
    const auto in_tunnel = [&](const Vec2& X) {
      return X.x() > -start && std::abs(X.y() - distance) < tunnel_half_width;
    };
    PlacedProtrusions cell(p, Vec2(-start, 0.0), in_tunnel);
    cell.begin(0.0);
    Outcome out = grow(cell, 1.0, distance, result.table);
    out.length.label = fmt::format("{:.0f} µm beside", distance);
    result.checks.push_back({fmt::format("length {:.0f} µm beside the middle of a tunnel (µm)", distance),
                             out.length.y.back(), 20.0, 0.0, "no dwarf of under 12 µm by a tunnel alone",
                             Sense::at_least});
    const double turned = std::atan2(cell.cell().cortex.x[cell.cell().protrusions.front().centre].y(),
                                     cell.cell().cortex.x[cell.cell().protrusions.front().centre].x() + start);
    result.remarks.push_back(
        fmt::format("{:.0f} µm beside the middle of a tunnel {:.0f} µm wide: {:.1f} µm, {}, turned by {:.0f} degrees.",
                    distance, 2.0 * tunnel_half_width, out.length.y.back(),
                    out.adheres ? "adheres" : "finds nothing to adhere to", turned / degree));
    beside.series.push_back(std::move(out.length));
  }
  result.add("stunting", "The force of growth goes with n . d_prot.", tilted);
  result.add("tunnel", "A protrusion in matrix that the cell has degraded before.", beside);
  return result;
}

} // namespace matrigrate::validation
