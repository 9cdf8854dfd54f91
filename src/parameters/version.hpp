#pragma once

#include "base/failure.hpp"
#include "parameters/schema.hpp"

#include <toml++/toml.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Files of other versions of the program. What those mean by a key that they do not have: Row::before. Test:
/// tests/unit/parameters/earlier_test.cpp
namespace matrigrate {

/// The version that a resolved file names in its key `version`. A file with that key was written by a program, so a
/// parameter that it lacks has the value of before, not today's default.
inline constexpr std::string_view this_version = "0.3.0";

/// The first version with today's model: of the same parameters, runs of it and later ones have the same results.
inline constexpr std::string_view model_since = "0.3.0";

/// The first line of a resolved file. The key `version` came later, after `last_without_key`.
inline constexpr std::string_view resolved_head =
    "# Every parameter of a simulation. Running this file again gives the same bits.\n";
inline constexpr std::string_view last_without_key = "0.2.0";

/// Whether a version, "0.3.0", has the model of this one; none is known of a later one.
bool has_this_model(std::string_view version);

/// "0.2.0" of "matrigrate 0.2.0 (9a32bbbb)", as checkpoints and lineages name a program.
std::string version_of_program(std::string_view program);

/// What another model means for results, a sentence's end: "the model has changed since 0.2.0: ...". Empty for a
/// version that has_this_model().
std::string model_text(std::string_view version);

// Parameters that earlier versions had: readings of the paper that lost the choice of closures, what laws say now, and
// drawings that the program no longer makes. Each accepts one value still: what the program now does. Other values are
// refused in a file that somebody wrote, but of drawings, which decide nothing. A file that a program wrote is read
// with them: as the law that says the same, or else kept in Origin::gone, so that what was made can be shown, and
// refused by who computes. A parameter that stood in the fingerprints of configurations stays there, so that finished
// runs keep their names.

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

/// A value as it stands in a scenario file, and that of a set of parameters.
std::string gone_value(const toml::node& value);
std::string gone_value(const Gone& parameter, const Parameters& p);

/// What is wrong with a value of a parameter that has gone; empty if it is the accepted one.
std::string fault_of_gone(const Gone& parameter, const toml::node& value);

/// "\"place\" has gone: an adhesion holds matter; ...", "20 has gone: write laws.initiation_bias = ..."
std::string gone_text(std::string_view value, const Gone& parameter);

/// The formula that says a value; none if no law does.
std::optional<std::string> formula_of_gone(const Gone& parameter, std::string_view value);

/// Faults of the readings in Origin::gone, which this program does not compute; none of parameters that it does.
/// @param place  stands for the file in them
std::vector<Fault> faults_of_gone(const Parameters& p, const std::string& place);

// Which set of closures the parameters of a run belong to. Versions had other sets as their defaults; a file that
// names some values of one and leaves out others mixes them.

struct Closures {
  std::string text; ///< "third set"; "third set, but for contact.fluid_share = 0.3"; "mixed: of the third set ...; of
                    ///< the second ..." if no set has all values that any set has
  std::string note; ///< what to do about closures that are not those of today's default, a sentence; empty for the
                    ///< third set, with or without values of no set
};

Closures closures_of(const Parameters& p);

} // namespace matrigrate
