#pragma once

#include "parameters/parameters.hpp"

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
  std::string_view text{};            ///< of a template: its file, with the source of each number; else empty
};

/// Those of the program, then the templates.
std::span<const Preset> presets();

/// A cell in a gel, with the source of each number in its comments: a file of scenarios/templates, which the program
/// carries with it (cmake/shipped.cmake). The second line describes it.
struct Template {
  std::string_view name; ///< of the file, without its ending
  std::string_view text;
};
std::span<const Template> templates();

/// @return the preset of that name, or null
const Preset* find_preset(std::string_view name);

Parameters parameters_of(const Preset& preset);

} // namespace matrigrate
