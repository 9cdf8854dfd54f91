#pragma once

#include <array>
#include <string_view>
#include <utility>

/// Files of earlier versions: what programs did that did not have a key yet. Test: tests/unit/parameters/write_test.cpp
namespace matrigrate {

/// The first line of a file that holds every parameter of the version that wrote it.
inline constexpr std::string_view resolved_head =
    "# Every parameter of a simulation. Running this file again gives the same bits.\n";

/// Keys that came later, and the value that stands for what was done before. A resolved file or a checkpoint without
/// such a key means this value, not the default of today; and the value is left out of the fingerprint of a
/// configuration, so that it is that of the earlier runs.
inline constexpr std::array<std::pair<std::string_view, std::string_view>, 6> before_their_keys{
    {{"cell.centre_of_mass", "\"area\""},
     {"adhesion.rest_speed", "\"0 nm/s\""},
     {"adhesion.hold", "\"place\""},
     {"adhesion.spread", "1"},
     {"adhesion.handover_time", "\"0.4 s\""},
     {"adhesion.handover_share", "0.9"}}};

} // namespace matrigrate
