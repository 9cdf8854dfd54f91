#pragma once

#include <string>

/// Human-readable durations. Test: tests/unit/base/base_test.cpp
namespace matrigrate {

/// A simulated time: "0 s", "45 min", "2 h 30 min".
/// @param seconds  >= 0
std::string time_text(double seconds);

/// A wall-clock duration: "45 s", "12 min", "3.2 h".
std::string wall_time_text(double seconds);

} // namespace matrigrate
