#pragma once

#include "parameters/parameters.hpp"
#include "run/observer.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// What a folder holds that a new run would be written into. Test: tests/apps/run_test.cpp
namespace matrigrate::run {

/// True if a folder does not exist or is empty, hidden files aside.
bool is_free(const std::filesystem::path& folder);

/// The names in a folder, hidden files aside, sorted; none if the folder does not exist.
std::vector<std::string> visible_entries(const std::filesystem::path& folder);

/// "run.duration: 1 h there, 6 min here", one for each parameter that differs, threads aside.
std::vector<std::string> differences(const Parameters& there, const Parameters& here);

/// Items for a message; of many items the first ones and the number of the rest.
std::string listed(std::vector<std::string> items, std::string_view separator);

/// @throws InputOutputError if the folder is that of a study, whose files a run would replace
void require_no_study(const std::filesystem::path& folder);

/// @throws InputOutputError if the folder is not empty, hidden files aside: says which run it holds, in which
///         parameters that run differs from p, and what can be done
void require_free(const std::filesystem::path& folder, const Parameters& p, RunObserver& observer);

/// Before the run in a folder is replaced: warns of the other files that it holds, which stay.
void warn_of_other_files(const std::filesystem::path& folder, RunObserver& observer);

} // namespace matrigrate::run
