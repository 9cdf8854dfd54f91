#pragma once

#include <string>
#include <string_view>

/// Values judged one by one, for programs in other languages, with the words of the reader.
/// Test: tests/unit/parameters/judge_test.cpp
namespace matrigrate {

/// @param questions  a JSON list. A value: {"path": "ecm.radius", "value": "60 um"}; a number that JSON cannot write:
///                   "real": "nan"; a value of another type: "type": "an array". A name that nothing has: {"path":
///                   "emc", "section": true}. The keys of [[cells]] are cells.x and cells.y.
/// @return a JSON list of as many answers {"fault": "...", "number": 60.0}. The fault is empty if nothing is wrong; the
///         number is in the documented unit, and 0 of what is no real number.
/// @throws ConfigurationError if this is no such list
std::string judged(std::string_view questions);

} // namespace matrigrate
