#pragma once

#include "study_plan/fault_list.hpp"

#include <toml++/toml.h>

#include <map>
#include <string>
#include <string_view>

/// Studies that an earlier version has written out, whose points may name parameters that have gone
/// (parameters/gone.hpp). Test: tests/unit/study_plan/plan_test.cpp
namespace matrigrate::study {

/// What points say by parameters that have gone: by the place of the point's table, path and value.
using GoneValues = std::map<Place, std::map<std::string, std::string, std::less<>>>;

/// Whether a program wrote the text of a study.
bool is_written_out(std::string_view text);

/// Says by laws what [[points]] and [[conditions]] say by parameters that laws have replaced, and takes the readings
/// that have gone out of points; of conditions they stay, to be refused.
/// @param scenario  of the study: what a point does not say
/// @return what points said
GoneValues follow_gone(toml::table& study, const toml::table& scenario);

} // namespace matrigrate::study
