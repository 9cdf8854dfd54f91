#pragma once

#include "run/folder_lock.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Exports that other programs make.
namespace matrigrate::apps {

/// A folder that is gone with all that is in it at the end of this object. What an export has left in it whose process
/// was killed goes before.
struct Scratch {
  std::filesystem::path path; ///< with a folder `made` in it
  run::FolderLock lock;

  explicit Scratch(const std::filesystem::path& in);
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch();
};

/// Runs a program to its end.
/// @throws InputOutputError with the last line that it says, if it fails
void call(const std::vector<std::string>& command, const Scratch& scratch);

/// Moves what was made to a folder.
void move_made(const Scratch& scratch, const std::filesystem::path& to);

} // namespace matrigrate::apps
