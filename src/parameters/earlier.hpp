#pragma once

#include <string_view>

/// Files of other versions of the program. What those mean by a key that they do not have: Row::before. Test:
/// tests/unit/parameters/earlier_test.cpp
namespace matrigrate {

/// The version that a resolved file names in its key `version`. A file with that key was written by a program, so a
/// parameter that it lacks has the value of before, not today's default.
inline constexpr std::string_view this_version = "0.3.0";

/// The first line of a resolved file. The key `version` came later.
inline constexpr std::string_view resolved_head =
    "# Every parameter of a simulation. Running this file again gives the same bits.\n";

} // namespace matrigrate
