#include "draw/colour_bar.hpp"

#include "draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace matrigrate::draw {

ColourScale fitted_scale(std::span<const double> values) {
  if (values.empty()) return {};
  const auto [low, high] = std::ranges::minmax(values);
  if (high - low > std::max(1e-12 * std::abs(low), 1e-150)) return {low, high};
  const double half = std::abs(low) <= 1e-150 ? 1.0 : 0.1 * std::abs(low); // a neighbourhood with legible ticks
  return {low - half, high + half};
}

int ColourScale::level(double value) const {
  if (!std::isfinite(value)) return -1;
  const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return std::min(static_cast<int>(share * colour_levels), colour_levels - 1);
}

std::vector<Tick> ColourScale::ticks() const { return linear_ticks(low, high, 7); }

double ColourScale::label_width() const {
  double width = 0.0;
  for (const Tick& tick : ticks()) width = std::max(width, svg::text_width(tick.label, svg::tick_size));
  return width;
}

std::string colour(double fraction) {
  // Anchors at equal distances; the colours between them are interpolated linearly.
  constexpr std::array<unsigned, 10> viridis{0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                             0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(viridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
  const double t = place - static_cast<double>(below);
  const auto mix = [&](unsigned shift) {
    const auto part = [&](unsigned rgb) { return static_cast<double>(rgb >> shift & 0xffU); };
    return std::lround(part(viridis[below]) + t * (part(viridis[below + 1]) - part(viridis[below])));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(16), mix(8), mix(0));
}

std::string level_colour(int level) { return colour((level + 0.5) / colour_levels); }

std::string colour_bar(const ColourScale& scale, double left, double top, double height) {
  const double bottom = top + height;
  const double step = height / colour_levels;
  std::string out;
  for (int level = 0; level < colour_levels; ++level) // each step reaches half a pixel under the next: no gap shows
    out += svg::rectangle(left, bottom - (level + 1) * step, colour_bar_width, step + (level > 0 ? 0.5 : 0.0),
                          level_colour(level));
  out += svg::frame(left, top, colour_bar_width, height);
  for (const Tick& t : scale.ticks()) {
    const double right = left + colour_bar_width;
    const double y = bottom - (t.value - scale.low) / (scale.high - scale.low) * height;
    out += svg::line(right, y, right + 5.0, y, svg::dark, 1.0);
    out += svg::text(right + 9.0, y + 5.5, t.label, {});
  }
  return out;
}

} // namespace matrigrate::draw
