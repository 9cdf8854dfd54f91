#pragma once

#include "observe/frame.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>

/// Numbers of many frames in few characters, as viewer/src/embedded.ts describes it. Test:
/// tests/unit/report/report_test.cpp
namespace matrigrate::report {

/// How numbers are stored: value = offset + scale q.
struct Packing {
  bool wide = false; ///< q of 16 bits with sign, else of 8 bits without
  int components = 1;
  double scale = 1.0;
  double offset = 0.0;
  bool delta = true; ///< whether frames after the first store differences of q
};

/// The numbers of one frame.
using FrameValues = std::function<const observe::Floats&(std::size_t frame)>;

/// {type, components, per_frame, scale, offset, delta, data}
/// @param frames  at least one, all of one size
nlohmann::ordered_json packed(const Packing& packing, std::size_t frames, const FrameValues& values);

} // namespace matrigrate::report
