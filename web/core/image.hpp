#pragma once

#include "state/state.hpp"

#include <string>
#include <string_view>

/// The state as bytes, in the order of the members, for the same build of the program to read. (The checkpoint of
/// src/run/store needs HDF5.) Test: web/tests/core.mjs
namespace matrigrate::live {

std::string image_of(const State& s);

/// @throws std::invalid_argument if the bytes are no image of this version, or are cut off
State state_of(std::string_view image);

} // namespace matrigrate::live
