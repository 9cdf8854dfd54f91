#pragma once

#include "observe/frame.hpp"

#include <nlohmann/json.hpp>

/// The frames of a run as the report's player takes them (viewer/README.md). Test: tests/unit/report/run_page_test.cpp
namespace matrigrate::io {

/// Takes away what the player does not show, where memory counts.
inline void keep_what_is_played(Frame& frame) { Floats().swap(frame.matrix.velocity); }

/// @return null if there are no frames
nlohmann::ordered_json film_json(const Film& film);

/// The limits of a layer's colours: all but one in a thousand values of solid particles lie inside.
struct Limits {
  double low = 0.0, high = 1.0;
};
Limits usual_limits(const Film& film, const Floats& (*field)(const Frame&));

} // namespace matrigrate::io
