#include "draw/axis.hpp"

#include "draw/svg.hpp"

#include <algorithm>

namespace matrigrate::draw {

namespace {

/// A value alone on its axis gets a neighbourhood that makes its ticks legible.
void widen(Axis& axis) {
  if (axis.log && axis.high / axis.low < 1.0 + 1e-9) {
    axis.low /= 3.0;
    axis.high *= 3.0;
  } else if (!axis.log && axis.high - axis.low <= std::max(1e-12 * std::abs(axis.low), 1e-150)) {
    const double half = std::abs(axis.low) <= 1e-150 ? 1.0 : 0.1 * std::abs(axis.low);
    axis.low -= half;
    axis.high += half;
  }
}

} // namespace

Axis fitted_axis(std::span<const double> values, bool log, double room, int most) {
  Axis axis;
  axis.log = log;
  axis.low = log ? 1.0 : 0.0;
  axis.high = log ? 10.0 : 1.0;
  if (!values.empty()) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    axis.low = *low;
    axis.high = *high;
    widen(axis);
    if (log) {
      const double factor = std::pow(axis.high / axis.low, room);
      axis.low /= factor;
      axis.high *= factor;
    } else {
      const double margin = room * (axis.high - axis.low);
      axis.low -= margin;
      axis.high += margin;
    }
  }
  axis.ticks = log ? log_ticks(axis.low, axis.high, most) : linear_ticks(axis.low, axis.high, most);
  return axis;
}

double label_width(const Axis& axis) {
  double width = 0.0;
  for (const Tick& tick : axis.ticks) width = std::max(width, svg::text_width(tick.label, svg::tick_size));
  return width;
}

} // namespace matrigrate::draw
