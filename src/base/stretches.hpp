#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace matrigrate {

/// Calls body(begin, end) for every stretch of indices whose flag is 0, in order: loops without a branch inside.
/// Test: tests/unit/base/base_test.cpp
template <class Body>
void each_unflagged_stretch(std::span<const std::uint8_t> flags, const Body& body) {
  for (auto begin = std::ranges::find(flags, 0), end = begin; begin != flags.end();
       begin = std::find(end, flags.end(), 0)) {
    end = std::find_if(begin, flags.end(), [](std::uint8_t flag) { return flag != 0; });
    body(static_cast<std::size_t>(begin - flags.begin()), static_cast<std::size_t>(end - flags.begin()));
  }
}

} // namespace matrigrate
