#include "draw/colour_bar.hpp"

#include "draw/svg.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate::draw {

int colour_level(double value, const Axis& axis) {
  if (!std::isfinite(value)) return -1;
  const double share = std::clamp((value - axis.low) / (axis.high - axis.low), 0.0, 1.0);
  return std::min(static_cast<int>(share * colour_levels), colour_levels - 1);
}

std::string level_colour(ColourMap map, int level) { return colour(map, (level + 0.5) / colour_levels); }

std::string colour_bar(const Axis& axis, ColourMap map, double left) {
  const double step = (axis.begin - axis.end) / colour_levels;
  std::string out;
  for (int level = 0; level < colour_levels; ++level) // each step reaches half a pixel under the next: no gap shows
    out += svg::rectangle(left, axis.begin - (level + 1) * step, colour_bar_width, step + (level > 0 ? 0.5 : 0.0),
                          level_colour(map, level));
  out += svg::frame(left, axis.end, colour_bar_width, axis.begin - axis.end);
  for (const Tick& t : axis.ticks) {
    const double right = left + colour_bar_width;
    out += svg::line(right, axis.at(t.value), right + 5.0, axis.at(t.value), svg::dark, 1.0);
    out += svg::text(right + 9.0, axis.at(t.value) + 5.5, t.label, {});
  }
  return out;
}

} // namespace matrigrate::draw
