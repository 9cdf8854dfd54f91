#include "draw/colour_bar.hpp"

#include "draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace matrigrate::draw {

namespace {

constexpr double slack = 1e-9; ///< share of a step by which a bound may miss its tick through rounding

/// mantissa x 10^exponent
struct RoundNumber {
  int mantissa = 1;
  int exponent = 0;
  double value() const { return mantissa * std::pow(10.0, exponent); }
};

RoundNumber round_number(double least) {
  const int exponent = static_cast<int>(std::floor(std::log10(least) + slack));
  for (const int mantissa : {1, 2, 5})
    if (mantissa * std::pow(10.0, exponent) >= least * (1.0 - slack)) return {mantissa, exponent};
  return {1, exponent + 1};
}

/// The typographic minus is as wide as a digit.
std::string with_minus(std::string_view number) {
  std::string out;
  for (const char c : number) out += c == '-' ? "\u2212" : std::string(1, c);
  return out;
}

/// A number with `decimals` decimals in units of 10^exponent.
std::string label(double value, int exponent, int decimals) {
  if (exponent == 0) return with_minus(fmt::format("{:.{}f}", value, decimals));
  if (value == 0.0) return "0";
  return with_minus(fmt::format("{:.{}f}e{}", value / std::pow(10.0, exponent), decimals, exponent));
}

} // namespace

double round_step(double least) { return round_number(least).value(); }

std::vector<Tick> linear_ticks(double low, double high, int most) {
  const RoundNumber step = round_number((high - low) / most);
  const double first = std::ceil(low / step.value() - slack);
  const double last = std::floor(high / step.value() + slack);
  // Numbers from 0.0001 to a million are written out, others in units of the power of ten of the largest one.
  const double largest = std::max(std::abs(first), std::abs(last)) * step.value();
  const int magnitude = largest > 0.0 ? static_cast<int>(std::floor(std::log10(largest) + slack)) : step.exponent;
  const int unit = magnitude >= -4 && magnitude < 6 ? 0 : magnitude;
  const int decimals = std::clamp(unit - step.exponent, 0, 17);
  std::vector<Tick> ticks;
  for (int i = 0; i <= most + 1 && first + i <= last; ++i) {
    const double value = (first + i) * step.value() + 0.0; // no negative zero
    ticks.push_back({value, label(value, unit, decimals)});
  }
  return ticks;
}

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
