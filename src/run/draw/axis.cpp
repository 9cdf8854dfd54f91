#include "draw/axis.hpp"

#include "draw/svg.hpp"

#include <algorithm>

namespace matrigrate::draw {

Axis fitted_axis(std::span<const double> values) {
  Axis axis;
  if (values.empty()) return axis;
  const auto [low, high] = std::ranges::minmax(values);
  axis.low = low;
  axis.high = high;
  if (high - low <= std::max(1e-12 * std::abs(low), 1e-150)) { // a value alone gets a neighbourhood with legible ticks
    const double half = std::abs(low) <= 1e-150 ? 1.0 : 0.1 * std::abs(low);
    axis.low -= half;
    axis.high += half;
  }
  return axis;
}

double label_width(const Axis& axis) {
  double width = 0.0;
  for (const Tick& tick : axis.ticks) width = std::max(width, svg::text_width(tick.label, svg::tick_size));
  return width;
}

} // namespace matrigrate::draw
