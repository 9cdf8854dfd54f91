#pragma once

#include "base/failure.hpp"
#include "parameters/schema.hpp"

#include <toml++/toml.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Parameters that earlier versions had: readings of the paper that lost the choice of closures, what laws say now, and
/// drawings that the program no longer makes. Each accepts one value still: what the program now does. Other values are
/// refused in a file that somebody wrote, but of drawings, which decide nothing. A file that a program wrote is read
/// with them: as the law that says the same, or else kept in Origin::gone, so that what was made can be shown, and
/// refused by who computes. A parameter that stood in the fingerprints of configurations stays there, so that finished
/// runs keep their names. Test: tests/unit/parameters/earlier_test.cpp
namespace matrigrate {

/// How a law says a value that has gone.
struct GoneFormula {
  std::string_view value; ///< as it stands in a scenario file; empty: any number, which takes the place of {}
  std::string_view formula;
};

struct Gone {
  std::string_view path;
  std::string_view behind; ///< the row behind which it stands in fingerprints, those of one row in the order of gone();
                           ///< empty if it does not
  std::string_view left;   ///< the value that is accepted, as it stands in a scenario file
  std::string_view before; ///< as Row::before; empty if all versions had it
  std::string_view fate;   ///< what the program does now; empty of what a law says
  std::string_view law = {}; ///< key of that law
  std::span<const GoneFormula> formulas = {};
  bool is_drawing = false; ///< whose values are all read
};

std::span<const Gone> gone();

/// Null if no version had a parameter of this path, or if it is still there.
const Gone* find_gone(std::string_view path);

/// A value as it stands in a scenario file.
std::string gone_value(const toml::node& value);

/// What is wrong with a value of a parameter that has gone; empty if it is the accepted one.
std::string fault_of_gone(const Gone& parameter, const toml::node& value);

/// "\"place\" has gone: an adhesion holds matter; ...", "20 has gone: write laws.initiation_bias = ..."
std::string gone_text(std::string_view value, const Gone& parameter);

/// The formula that says a value; none if no law does.
std::optional<std::string> formula_of_gone(const Gone& parameter, std::string_view value);

/// Of the parameters that have gone and in which two sets differ: path, value of a, value of b.
std::vector<std::array<std::string, 3>> gone_that_differ(const Parameters& a, const Parameters& b);

/// Faults of the readings in Origin::gone, which this program does not compute; none of parameters that it does.
/// @param place  stands for the file in them
std::vector<Fault> faults_of_gone(const Parameters& p, const std::string& place);

} // namespace matrigrate
