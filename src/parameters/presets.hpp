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

/// A scenario with the source of each number in its comments, which the program carries with it (cmake/shipped.cmake):
/// a cell in a gel, of scenarios/templates, or a published law, of scenarios/laws. The second line describes it.
struct Template {
  std::string_view name; ///< of the file, without its ending
  std::string_view text;
};
std::span<const Template> templates();
std::span<const Template> law_files();

/// The published laws, as presets.
std::span<const Preset> published_laws();

/// @return the preset of that name among presets(), or others, or null
const Preset* find_preset(std::string_view name, std::span<const Preset> among = presets());

Parameters parameters_of(const Preset& preset);

} // namespace matrigrate
