#pragma once

#include <cmath>

namespace matrigrate::run {

/// When a regular event is due. The first event is due at 0.
class Cadence {
public:
  /// @param interval  0: never due [s]
  /// @param step      the time step, which decides how exactly times agree [s]
  Cadence(double interval, double step) : m_interval(interval), m_slack(1e-6 * step) {}

  /// True if an event is due at t. The following event is then due at the next multiple of the interval.
  bool due(double t) {
    if (m_interval <= 0.0 || t < m_next - m_slack) return false;
    m_next = m_interval * (std::floor((t + m_slack) / m_interval) + 1.0);
    return true;
  }

private:
  double m_interval;
  double m_slack;
  double m_next = 0.0;
};

} // namespace matrigrate::run
