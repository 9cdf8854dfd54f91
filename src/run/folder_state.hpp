#pragma once

#include "parameters/parameters.hpp"
#include "run/observer.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// What a folder holds, and whether a verb takes it: the sentences of refusal are the table in folder_state.cpp.
/// Test: tests/unit/run/folder_state_test.cpp, tests/apps/run_test.cpp, tests/apps/study_test.cpp
namespace matrigrate::run {

/// What is true of a folder; several may be.
struct Holds {
  enum : unsigned {
    missing = 1U << 0U,
    a_file = 1U << 1U,        ///< is no folder
    closed = 1U << 2U,        ///< cannot be listed
    something = 1U << 3U,     ///< is not empty, hidden files aside
    run_json = 1U << 4U,      ///< has one, whole or not
    a_run = 1U << 5U,         ///< its run.json is whole
    checkpoint = 1U << 6U,    ///< has the last one, or the one before
    this_run = 1U << 7U,      ///< of the parameters that were asked for, done or not; threads may differ
    this_branch = 1U << 8U,   ///< the one that was asked for
    begun_branch = 1U << 9U,  ///< that one, killed before it had a checkpoint
    a_study = 1U << 10U,      ///< has study.resolved.toml
    other_study = 1U << 11U,  ///< neither extends the one that was asked for nor is extended by it
    unclear_study = 1U << 12U ///< cannot be compared with it
  };
};

/// A folder as it was found.
struct FolderState {
  std::filesystem::path folder;
  unsigned holds = 0;               ///< of Holds
  std::vector<std::string> names{}; ///< of its entries, hidden files aside, sorted
  nlohmann::ordered_json record{};  ///< run.json; null if it is missing or damaged
  std::string detail{};             ///< how what it holds differs from what was asked for, or why it is closed

  bool has(unsigned what) const { return (holds & what) != 0; }
};

FolderState look_at(const std::filesystem::path& folder);

/// Whether it holds the run of p, and otherwise in what that run differs.
FolderState look_at(const std::filesystem::path& folder, const Parameters& p, RunObserver& observer);

/// Whether it holds the branch with these parameters.
/// @param event  that begins it, in its lineage
FolderState look_at_branch(const std::filesystem::path& folder, const Parameters& p,
                           const nlohmann::ordered_json& event);

/// What a folder is wanted for.
enum class Use : unsigned {
  run = 1U << 0U,      ///< to write a run into
  run_anew = 1U << 1U, ///< the same with --force
  branch = 1U << 2U,   ///< to write a branch into
  study = 1U << 3U,    ///< to compute a study in
  exports = 1U << 4U,  ///< to write exports into
  results = 1U << 5U,  ///< to write what has --force into
  pictures = 1U << 6U, ///< to write what has no --force into
  resume = 1U << 7U,   ///< to go on from a checkpoint
  see_run = 1U << 8U,  ///< to read a run
  see_study = 1U << 9U,
  see_either = 1U << 10U,
  see_files = 1U << 11U ///< to read whatever is in it
};

/// @throws InputOutputError if the folder is not taken for this use, with the sentence of the table
void require(const FolderState& state, Use use);

/// Before the run in a folder is replaced: warns of the other files that it holds, which stay.
void warn_of_other_files(const std::filesystem::path& folder, RunObserver& observer);

/// "run.duration: 1 h there, 6 min here", one for each parameter that differs, threads aside.
std::vector<std::string> differences(const Parameters& there, const Parameters& here);

/// Items for a message; of many items the first ones and the number of the rest.
std::string listed(std::vector<std::string> items, std::string_view separator);

} // namespace matrigrate::run
