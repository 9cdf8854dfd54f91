#include "draw/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

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

/// mantissa x 10^exponent, written out as long as it is short.
std::string decade_label(int mantissa, int exponent) {
  if (std::abs(exponent) > 4) return with_minus(fmt::format("{}e{}", mantissa, exponent));
  return fmt::format("{:.{}f}", mantissa * std::pow(10.0, exponent), std::max(0, -exponent));
}

/// Multiples 1 .. 9 of the decades in [low, high]; those for which `labelled(mantissa, exponent)` have a label.
template <class Labelled>
std::vector<Tick> decades(double low, double high, bool between, const Labelled& labelled) {
  std::vector<Tick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(low) - slack));
  const int last = static_cast<int>(std::ceil(std::log10(high) + slack));
  for (int exponent = first; exponent <= last; ++exponent)
    for (int mantissa = 1; mantissa <= 9; ++mantissa) {
      const double value = RoundNumber{mantissa, exponent}.value();
      if (value < low * (1.0 - slack) || value > high * (1.0 + slack)) continue;
      if (labelled(mantissa, exponent))
        ticks.push_back({value, decade_label(mantissa, exponent)});
      else if (between)
        ticks.push_back({value, ""});
    }
  return ticks;
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

std::vector<Tick> log_ticks(double low, double high, int most) {
  const double span = std::log10(high) - std::log10(low);
  if (span >= 2.0) {
    const int stride = static_cast<int>(std::ceil(span / most));
    return decades(low, high, span <= 6.0, [&](int m, int e) { return m == 1 && e % stride == 0; });
  }
  auto ticks = decades(low, high, true, [](int m, int) { return m == 1 || m == 2 || m == 5; });
  const auto labels = std::count_if(ticks.begin(), ticks.end(), [](const Tick& t) { return !t.label.empty(); });
  return labels >= 3 ? ticks : linear_ticks(low, high, most);
}

} // namespace matrigrate::draw
