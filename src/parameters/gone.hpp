#pragma once

#include "parameters/schema.hpp"

#include <toml++/toml.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Parameters that earlier versions had: readings of the paper that lost the choice of closures, what laws say now, and
/// drawings that the program no longer makes. Each accepts one value still: what the program now does. Other values are
/// refused, but of drawings, which decide nothing. A parameter that stood in the fingerprints of configurations stays
/// there, so that finished runs keep their names.
/// Test: tests/unit/parameters/earlier_test.cpp
namespace matrigrate {

struct Gone {
  std::string_view path;
  std::string_view behind; ///< the row, or the parameter that has gone as well, behind which it stands in fingerprints;
                           ///< empty if it does not
  std::string_view left;   ///< the value that is accepted, as it stands in a scenario file
  std::string_view before; ///< as Row::before; empty if all versions had it
  std::string_view fate;   ///< what the program does now; of what a law says: how to write it, {} for the value
  bool is_law = false;
  bool is_drawing = false; ///< whose values are all read
};

std::span<const Gone> gone();

/// Null if no version had a parameter of this path, or if it is still there.
const Gone* find_gone(std::string_view path);

/// What is wrong with a value of a parameter that has gone; empty if it is the accepted one.
std::string fault_of_gone(const Gone& parameter, const toml::node& value);

/// "\"place\" has gone: an adhesion holds matter; ...", "20 has gone: write laws.initiation_bias = ..."
std::string gone_text(std::string_view value, const Gone& parameter);

} // namespace matrigrate
