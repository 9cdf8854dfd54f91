#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace matrigrate {

/// W_slope(r)/W_slope(0) of the kernel below: (1 - q/2)^3, and 0 beyond its support. For any number type and without a
/// branch, so that loops over distances can be vectorised. Test: tests/unit/sph/sph_test.cpp
/// @param r  distance [um]   @param per_support  1/(2h) [1/um]
template <class Real>
[[gnu::always_inline]] inline Real slope_shape(const Real& r, const Real& per_support) {
  using std::abs;
  const Real left = Real(1) - r * per_support;
  const Real a = Real(0.5) * (left + abs(left));
  return a * a * a;
}

/// Wendland C2 kernel of the plane (Wendland 1995; MODEL.md, I2):
///   W(r) = 7/(4 pi h^2) (1 - q/2)^4 (2q + 1),  q = r/h < 2, and 0 beyond.
/// Its gradient at particle i is grad_i W_ij = W_slope(|x_ij|) x_ij. Test: tests/unit/sph/sph_test.cpp
class Kernel {
public:
  /// @param h  smoothing length [um], > 0
  explicit Kernel(double h)
      : m_h(h), m_per_h(1.0 / h), m_norm(7.0 / (4.0 * std::numbers::pi * h * h)),
        m_slope_norm(-5.0 * m_norm / (h * h)) {}

  double h() const { return m_h; }
  double support() const { return 2.0 * m_h; } ///< radius beyond which W is 0 [um]

  /// @param r  distance [um], >= 0   @return W [1/um^2]
  double W(double r) const {
    const double q = r * m_per_h;
    const double a = std::max(0.0, 1.0 - 0.5 * q); // without a branch, so that loops can be vectorised
    return m_norm * (a * a) * (a * a) * (2.0 * q + 1.0);
  }

  /// (1/r) dW/dr, finite at r = 0, never positive.
  /// @param r  distance [um], >= 0   @return [1/um^4]
  double W_slope(double r) const {
    const double a = std::max(0.0, 1.0 - 0.5 * m_per_h * r);
    return m_slope_norm * a * a * a;
  }

private:
  double m_h;
  double m_per_h; // 1/h
  double m_norm;
  double m_slope_norm;
};

} // namespace matrigrate
