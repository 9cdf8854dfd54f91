#pragma once

#include "parameters/parameters.hpp"
#include "run/observer.hpp"

#include <filesystem>

/// What a folder holds that a new run would be written into. Test: tests/apps/run_test.cpp
namespace matrigrate::run {

/// Whether a folder is not there or empty, hidden files aside.
bool is_free(const std::filesystem::path& folder);

/// @throws InputOutputError if the folder is that of a study, whose files a run would replace
void require_no_study(const std::filesystem::path& folder);

/// @throws InputOutputError if the folder is not empty, hidden files aside: says which run it holds, in which
///         parameters that run differs from p, and what can be done
void require_free(const std::filesystem::path& folder, const Parameters& p, RunObserver& observer);

/// Before the run in a folder is replaced: warns of the other files that it holds, which stay.
void warn_of_other_files(const std::filesystem::path& folder, RunObserver& observer);

} // namespace matrigrate::run
