#pragma once

#include "validation/specimen.hpp"

#include <cstddef>
#include <functional>

namespace matrigrate::validation {

/// A round cell in a small disc of matrix whose protrusions begin where and when they are told to; their adhesions do
/// not disassemble.
class PlacedProtrusions {
public:
  /// @param p      material and numerics; the radius of the disc is set here
  /// @param start  place of the cell [um]
  /// @param fluid  whether the matrix at a point is fluid from the beginning; nowhere, if none is given
  PlacedProtrusions(const Parameters& p, const Vec2& start, const std::function<bool(const Vec2&)>& fluid = {});

  /// Begins a protrusion around the particle that stood at `angle` when the cell was round [rad].
  /// @param tilt  of its direction against the line from the centre of mass through that particle [rad]
  void begin(double angle, double tilt = 0.0);

  void march_for(double seconds, const std::function<bool(const State&)>& each_step = {}, const Loads& loads = {});

  /// @param k  in the order in which they began
  double length(std::size_t k) const;     ///< from the middle of the base to the tip, now [um]
  double base_width(std::size_t k) const; ///< between the two ends of the base, now [um]
  double slack(std::size_t k) const;      ///< contour over its two sides, laid straight, now [-]

  const Parameters& parameters() const { return m_simulation.p; }
  const State& state() const { return m_simulation.s; }
  const Cell& cell() const { return state().cells.front(); }

private:
  Simulation m_simulation;
};

/// A cell whose only protrusion has just begun to grow. It starts off the centre, so that the tip stays clear of the
/// rim.
class SingleProtrusion : public PlacedProtrusions {
public:
  /// @param angle  direction of growth [rad]
  SingleProtrusion(const Parameters& p, double angle);

  using PlacedProtrusions::length;
  double length() const { return length(0); } ///< l_prot now [um]
  const Protrusion& protrusion() const { return cell().protrusions.front(); }
};

} // namespace matrigrate::validation
