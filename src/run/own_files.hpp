#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The names of all files that the program writes into the folder of a run or of an export, so that it replaces and
/// removes its own files and no others. Test: tests/apps/run_test.cpp, tests/apps/fields_test.cpp
namespace matrigrate::run {

/// A kind of export and the names of its files, as a regular expression (ECMAScript).
struct ExportKind {
  std::string_view option; ///< "--png"
  std::string_view names;
};
std::span<const ExportKind> export_kinds();

/// The files of a kind that a folder holds; none if it is not there.
/// @throws InputOutputError if it cannot be read
std::vector<std::filesystem::path> files_of(const ExportKind& kind, const std::filesystem::path& folder);

/// Removes all files of a run from its folder: results, checkpoints, and exports in the folder `export`.
/// Everything else stays, as does the lock. Checkpoints go first, so that no part of the old run can be resumed.
/// @throws InputOutputError naming the file that cannot be removed
void remove_run_files(const std::filesystem::path& folder);

/// @throws InputOutputError if `snapshots` or `checkpoints` in the folder is a symbolic link: files of a run would be
///         written, and removed, somewhere else
void require_no_links(const std::filesystem::path& folder);

/// The entries of a folder that are not files of a run, hidden files aside, sorted.
std::vector<std::string> foreign_entries(const std::filesystem::path& folder);

/// Removes the temporary files of a run that killed writers left behind. No other process may be writing.
void remove_temporaries(const std::filesystem::path& folder);

/// Removes a file, if it is there.
/// @throws InputOutputError naming the path and the reason
void remove_file(const std::filesystem::path& file);

} // namespace matrigrate::run
