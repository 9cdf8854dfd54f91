#pragma once

#include "validation/specimen.hpp"

#include <functional>

namespace matrigrate::validation {

/// A round cell in a small disc of matrix whose only protrusion has just begun to grow; its adhesion does not
/// disassemble. The cell starts off the centre, so that the tip stays clear of the rim.
class SingleProtrusion {
public:
  /// @param p      material and numerics; the radius of the disc is set here
  /// @param angle  direction of growth [rad]
  SingleProtrusion(const Parameters& p, double angle);

  void march_for(double seconds, const std::function<bool(const State&)>& each_step = {});

  double length() const; ///< l_prot now, from the middle of the base to the tip [um]
  const State& state() const { return m_simulation.s; }
  const Cell& cell() const { return state().cells.front(); }
  const Protrusion& protrusion() const { return cell().protrusions.front(); }

private:
  Simulation m_simulation;
};

} // namespace matrigrate::validation
