#pragma once

#include "base/parallel.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace matrigrate {

/// Velocities or forces as a structure of arrays: all x components before all y components, both padded with zeros. So
/// `lanes` numbers may be read from any position, and loops over whole fields need no special cases.
template <class Number>
class FieldOf {
public:
  static constexpr std::size_t lanes = 8;

  /// Sets the number of nodes; all values become zero.
  void resize(std::size_t n) {
    m_size = n;
    m_stride = 2 * lanes + (n + lanes - 1) / lanes * lanes;
    m_values.assign(2 * m_stride, Number(0));
  }
  std::size_t size() const { return m_size; }
  Number* x() { return m_values.data() + lanes; }
  Number* y() { return m_values.data() + m_stride + lanes; }
  const Number* x() const { return m_values.data() + lanes; }
  const Number* y() const { return m_values.data() + m_stride + lanes; }

  /// All values, including the padding; fields of equal size correspond value by value.
  std::vector<Number>& values() { return m_values; }
  const std::vector<Number>& values() const { return m_values; }
  void set_zero() { std::fill(m_values.begin(), m_values.end(), Number(0)); }

  /// Calls body(begin, end) for ranges of values that make up both components, in any order. A thread takes x and y of
  /// the same nodes, as in loops over nodes, so that they stay in its cache.
  template <class Body>
  void each_range(const Body& body) const {
    parallel_ranges(m_size, light_grain, [&](std::size_t begin, std::size_t end) {
      for (const std::size_t first : {lanes, m_stride + lanes}) body(first + begin, first + end);
    });
  }

private:
  std::size_t m_size = 0, m_stride = 0;
  std::vector<Number> m_values;
};

using Field = FieldOf<float>;        ///< of corrections
using DoubleField = FieldOf<double>; ///< of solutions and their residuals

/// |a|^2 over both components.
inline double squared_norm(const DoubleField& a) {
  using Lanes = Eigen::Array<double, 4, 1>;
  const double* p = a.values().data();
  const Lanes sum = ordered_sum<Lanes>(a.values().size() / 4, Lanes::Zero(), [p](std::size_t k) -> Lanes {
    return Eigen::Map<const Lanes>(p + 4 * k).square();
  });
  return sum.sum();
}

/// a . b over both components, summed in double precision.
double dot(const Field& a, const Field& b);

/// b = factor a.   @return b . b
double assign_scaled(double factor, const DoubleField& a, Field& b);

/// z = d r, value by value.
inline void assign_product(const Field& d, const Field& r, Field& z) {
  const float* a = d.values().data();
  const float* b = r.values().data();
  float* to = z.values().data();
  z.each_range([=](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) to[k] = a[k] * b[k];
  });
}

/// z += d r, value by value.
inline void add_product(const Field& d, const Field& r, Field& z) {
  const float* a = d.values().data();
  const float* b = r.values().data();
  float* to = z.values().data();
  z.each_range([=](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) to[k] += a[k] * b[k];
  });
}

/// The same.   @return b . z
double add_product_and_dot(const Field& d, const Field& r, Field& z, const Field& b);

/// x += alpha p and r -= alpha q, a step of conjugate gradients.   @return r . r
double conjugate_gradient_step(float alpha, const Field& p, const Field& q, Field& x, Field& r);

/// p = z + beta p.
inline void extend(const Field& z, float beta, Field& p) {
  const float* a = z.values().data();
  float* to = p.values().data();
  p.each_range([=](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) to[k] = a[k] + beta * to[k];
  });
}

} // namespace matrigrate
