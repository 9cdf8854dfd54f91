#pragma once

#include "parameters/presets.hpp"

#include <string>

/// What is written from the table of parameters. Test: tests/unit/parameters/write_test.cpp
namespace matrigrate {

/// The resolved scenario: every parameter with its value and unit; parse_parameters gives the same bits back.
std::string to_toml(const Parameters& p);

/// Every parameter that counts(), a line each: what decides on a run, however its descriptions are worded and whatever
/// parameters came later. Its hash is the fingerprint of a configuration.
std::string values_text(const Parameters& p);

/// The scenario that `new` writes: the usual parameters to be edited, the numerical ones commented out at their
/// defaults; of a template its file.
/// @param schema  where json_schema() lies, seen from the file, for the first line, by which editors find it
std::string new_scenario(const Preset& preset, const std::string& schema);

/// JSON schema (draft 7) of a scenario file, for editors that complete and check TOML.
std::string json_schema();

/// docs/parameters.md: a table for each section.
std::string parameters_markdown();

} // namespace matrigrate
