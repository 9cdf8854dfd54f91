#include "draw/colour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace matrigrate::draw {

namespace {

struct Rgb {
  int red, green, blue;
};

// Anchors at equal distances; the colours between them are interpolated linearly.
constexpr std::array<Rgb, 10> viridis{{{68, 1, 84},
                                       {72, 40, 120},
                                       {62, 73, 137},
                                       {49, 104, 142},
                                       {38, 130, 142},
                                       {31, 158, 137},
                                       {53, 183, 121},
                                       {110, 206, 88},
                                       {181, 222, 43},
                                       {253, 231, 37}}};
constexpr std::array<Rgb, 7> blue_white_orange{
    {{16, 66, 128}, {66, 130, 190}, {158, 197, 228}, {240, 240, 240}, {247, 190, 127}, {217, 119, 30}, {140, 62, 0}}};

} // namespace

std::string colour(ColourMap map, double fraction) {
  const std::span<const Rgb> anchors =
      map == ColourMap::sequential ? std::span<const Rgb>(viridis) : std::span<const Rgb>(blue_white_orange);
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(anchors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
  const double t = place - static_cast<double>(below);
  const auto mix = [&](int a, int b) { return static_cast<int>(std::lround(a + t * (b - a))); };
  const Rgb& a = anchors[below];
  const Rgb& b = anchors[below + 1];
  return fmt::format("#{:02x}{:02x}{:02x}", mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue));
}

} // namespace matrigrate::draw
