#pragma once

#include "parameters/parameters.hpp"

#include <filesystem>

/// What a folder holds that a new run would be written into. Test: tests/apps/run_test.cpp
namespace matrigrate::apps {

/// Whether a folder is not there or empty, hidden files aside.
bool is_free(const std::filesystem::path& folder);

/// @throws InputOutputError if the folder is that of a study, whose files a run would replace
void require_no_study(const std::filesystem::path& folder);

/// @throws InputOutputError if the folder is not empty, hidden files aside: says which run it holds, in which
///         parameters that run differs from p, and what can be done
void require_free(const std::filesystem::path& folder, const Parameters& p);

/// Before the run in a folder is replaced: says which other files it holds, which stay.
void tell_what_stays(const std::filesystem::path& folder);

} // namespace matrigrate::apps
