#pragma once

#include "observe/frame.hpp"
#include "parameters/parameters.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>

/// The frames of a run as the report's player takes them (viewer/src/contract.ts). Test:
/// tests/unit/report/run_page_test.cpp
namespace matrigrate::report {

/// Takes away what the player does not show, where memory counts.
inline void keep_what_is_played(observe::Frame& frame) { observe::Floats().swap(frame.matrix.velocity); }

/// @return null if there are no frames
nlohmann::ordered_json film_json(const observe::Film& film);

/// Places of the particles of rigid obstacles: [[x, y], ...] [um].   @return null without any
nlohmann::ordered_json obstacles_json(const observe::FrameHead& head);

/// The fibres, which are the same at all times: between which particles, and from which strain on they stiffen. A
/// fibre's strain follows from the positions of its ends.   @return null without fibres
nlohmann::ordered_json fibres_json(const Parameters& p);

/// The limits of a layer's colours: all but one in a thousand values of solid particles lie inside.
struct Limits {
  double low = 0.0, high = 1.0;
};
Limits usual_limits(const observe::Film& film, const observe::Floats observe::MatrixFrame::*field);

// Numbers of many frames in few characters, as viewer/src/embedded.ts describes it. Test:
// tests/unit/report/report_test.cpp

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
