#pragma once

#include "validation/specimen.hpp"

#include <cstdint>

namespace matrigrate::validation {

/// A round cell in a small disc of matrix whose only protrusion has just begun to grow; no other one follows, and its
/// adhesion does not disassemble. The cell starts off the centre, so that the tip stays clear of the rim.
class SingleProtrusion {
public:
  /// @param p      material and numerics; geometry of the disc and place of the cell are set here
  /// @param angle  direction of growth [rad]
  SingleProtrusion(Parameters p, double angle);

  void march_for(double seconds, const std::function<bool(const State&)>& each_step = {});

  double length() const; ///< l_prot now [um]
  const Protrusion& protrusion() const { return m_specimen.s.protrusions.front(); }
  const State& state() const { return m_specimen.s; }

private:
  Specimen m_specimen;
};

} // namespace matrigrate::validation
