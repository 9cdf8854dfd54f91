#pragma once

#include "study/effects.hpp"

#include <string>

namespace matrigrate::apps {

/// Factor sets by discrepancy and factors by effect, the first ten of each, for people; empty where there are none.
/// Test: tests/apps/screening_test.cpp
std::string screening_text(const study::Study& study, const study::Screening& screening);

} // namespace matrigrate::apps
