#pragma once

#include "base/pack.hpp"

#include <cstddef>

namespace matrigrate {

/// Eight numbers in registers, with the operations of a law: what the compiler makes of a loop over particles.
struct Eight {
  Doubles low{}, high{};

  Eight() = default;
  explicit Eight(double a) {
    fill(a, low);
    fill(a, high);
  }
  Eight(const Doubles& a, const Doubles& b) : low(a), high(b) {}

  double operator[](std::size_t l) const { return l < 4 ? low[l] : high[l - 4]; }
  void set(std::size_t l, double a) {
    if (l < 4)
      low[l] = a;
    else
      high[l - 4] = a;
  }

  friend Eight operator+(const Eight& a, const Eight& b) { return {a.low + b.low, a.high + b.high}; }
  friend Eight operator-(const Eight& a, const Eight& b) { return {a.low - b.low, a.high - b.high}; }
  friend Eight operator*(const Eight& a, const Eight& b) { return {a.low * b.low, a.high * b.high}; }
  friend Eight operator/(const Eight& a, const Eight& b) { return {a.low / b.low, a.high / b.high}; }
  friend Eight operator-(const Eight& a) { return {-a.low, -a.high}; }
  friend Eight operator+(double a, const Eight& b) { return Eight(a) + b; }
  friend Eight operator-(double a, const Eight& b) { return Eight(a) - b; }
  friend Eight operator-(const Eight& a, double b) { return a - Eight(b); }
  friend Eight operator*(double a, const Eight& b) { return Eight(a) * b; }
  friend Eight operator/(double a, const Eight& b) { return Eight(a) / b; }
  friend Eight operator/(const Eight& a, double b) { return a / Eight(b); }
  friend Eight max(const Eight& a, const Eight& b) {
    return {a.low < b.low ? b.low : a.low, a.high < b.high ? b.high : a.high};
  }
  friend Eight min(const Eight& a, const Eight& b) {
    return {b.low < a.low ? b.low : a.low, b.high < a.high ? b.high : a.high};
  }
  friend Eight abs(const Eight& a) { return max(a, -a); }
};

} // namespace matrigrate
