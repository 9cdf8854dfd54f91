#pragma once

#include "observe/frame.hpp"

#include <cstdint>
#include <vector>

/// The adhesions of a frame as points, for programs that draw fields. Test: tests/unit/store/field_file_test.cpp
namespace matrigrate::store {

/// An entry for each protrusion that adheres, in the order of the frame's protrusions.
struct Anchors {
  observe::Floats x;             ///< where they adhere [um]
  std::vector<std::uint32_t> id; ///< of the protrusions
  observe::Floats f_mat;         ///< maturation [-]
  observe::Floats force;         ///< in the adhesion [nN]

  std::size_t size() const { return id.size(); }
};

Anchors anchors(const observe::Frame& frame);

} // namespace matrigrate::store
