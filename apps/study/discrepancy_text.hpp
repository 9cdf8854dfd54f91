#pragma once

#include "study_results/discrepancy.hpp"

#include <string>

namespace matrigrate::apps {

/// Factor sets by discrepancy, the first ten, for people; empty without targets. Test: tests/apps/discrepancy_test.cpp
std::string discrepancy_text(const study::Study& study, const std::vector<study::Discrepancy>& all);

} // namespace matrigrate::apps
