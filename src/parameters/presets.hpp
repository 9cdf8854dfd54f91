#pragma once

#include "parameters/parameters.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Scenarios that ship with the program. Test: tests/unit/parameters/write_test.cpp
namespace matrigrate {

struct Preset {
  std::string_view name;
  std::string_view description;
  std::vector<std::string> overrides; ///< what differs from the defaults, as after --set
};

std::span<const Preset> presets();

/// @return the preset of that name, or null
const Preset* find_preset(std::string_view name);

Parameters parameters_of(const Preset& preset);

} // namespace matrigrate
