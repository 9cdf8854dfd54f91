#pragma once

#include "base/file.hpp"
#include "store/run_memory.hpp"

#include <unistd.h>

#include <filesystem>
#include <string>

namespace matrigrate::store {

/// A folder with the tables of a run; it is removed at the end.
struct FolderOfTables {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("matrigrate-tables-" + std::to_string(::getpid()));

  FolderOfTables() { std::filesystem::create_directories(path); }
  FolderOfTables(const FolderOfTables&) = delete;
  FolderOfTables& operator=(const FolderOfTables&) = delete;
  ~FolderOfTables() { std::filesystem::remove_all(path); }

  void write(const RunMemory& memory) const {
    for (const auto& [name, text] : memory.tables) write_file(path / name, text);
  }
};

} // namespace matrigrate::store
