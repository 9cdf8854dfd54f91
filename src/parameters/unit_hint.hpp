#pragma once

#include <string>
#include <string_view>

namespace matrigrate::units {

/// "; did you mean kPa?" of "kpa"; empty if no unit has these letters, nor these as its name. Where several have, the
/// most common one is meant. Test: tests/unit/parameters/units_test.cpp
std::string unit_meant(std::string_view text);

} // namespace matrigrate::units
