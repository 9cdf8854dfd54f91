#pragma once

#include "state/state.hpp"

#include <string>
#include <string_view>

/// A whole state as bytes, for the program that made them: the live page keeps them, tests compare them.
/// Test: tests/unit/store/every_member_test.cpp
namespace matrigrate {

/// Two states have the same image exactly if all their numbers have the same bits.
std::string image_of(const State& s);

/// The state of which this is the image.
/// @throws std::invalid_argument if it is none, is cut off, or is of another version
State state_of(std::string_view image);

} // namespace matrigrate
