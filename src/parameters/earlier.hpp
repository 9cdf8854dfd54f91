#pragma once

#include "parameters/schema.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>

/// Files of earlier versions: what programs did that did not have a key yet. Test: tests/unit/parameters/write_test.cpp
namespace matrigrate {

/// The first line of a file that holds every parameter of the version that wrote it.
inline constexpr std::string_view resolved_head =
    "# Every parameter of a simulation. Running this file again gives the same bits.\n";

/// A key, and a value.
using KeyBefore = std::pair<std::string_view, std::string_view>;

/// Keys that came later, and the value that stands for what was done before. A resolved file or a checkpoint without
/// such a key means this value, not the default of today; and the value is left out of the fingerprint of a
/// configuration, so that it is that of the earlier runs. In place of a value stands the path of the key whose value it
/// was.
inline constexpr std::array<KeyBefore, 11> before_their_keys{{{"cell.centre_of_mass", "\"area\""},
                                                              {"adhesion.rest_speed", "\"0 nm/s\""},
                                                              {"adhesion.hold", "\"place\""},
                                                              {"adhesion.spread", "1"},
                                                              {"adhesion.handover_time", "\"0.4 s\""},
                                                              {"adhesion.handover_share", "0.9"},
                                                              {"contact.body_fluid_share", "contact.fluid_share"},
                                                              {"adhesion.pinned_particles", "3"},
                                                              {"adhesion.maturation_strands", "1"},
                                                              {"degradation.body_rear_share", "1"},
                                                              {"degradation.smaller_share", "1"}}};

/// A value of the table as it stands in a scenario file with these parameters.
inline std::string value_before(std::string_view value, const Parameters& p) {
  const Row* other = find_row(value);
  return other != nullptr ? value_text(*other, p) : std::string(value);
}

} // namespace matrigrate
