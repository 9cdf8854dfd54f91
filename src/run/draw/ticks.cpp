#include "draw/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
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

} // namespace matrigrate::draw
