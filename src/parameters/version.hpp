#pragma once

#include <string>
#include <string_view>

/// Files of other versions of the program. What those mean by a key that they do not have: Row::before; by keys that
/// have gone: parameters/gone.hpp. Test: tests/unit/parameters/earlier_test.cpp
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

} // namespace matrigrate
