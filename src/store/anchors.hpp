#pragma once

#include "observe/frame.hpp"

#include <cstdint>
#include <vector>

/// The adhesions of a frame as points, for programs that draw fields. Test: tests/unit/store/vtk_files_test.cpp
namespace matrigrate::io {

/// An entry for each protrusion that adheres, in the order of the frame's protrusions.
struct Anchors {
  Floats x;                      ///< where they adhere [um]
  std::vector<std::uint32_t> id; ///< of the protrusions
  Floats f_mat;                  ///< maturation [-]
  Floats force;                  ///< in the adhesion [nN]

  std::size_t size() const { return id.size(); }
};

Anchors anchors(const Frame& frame);

} // namespace matrigrate::io
