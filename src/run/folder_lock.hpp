#pragma once

#include "base/platform.hpp"

#include <chrono>
#include <filesystem>

namespace matrigrate::run {

/// A lock on a file, held until the end of this object and of all commands started meanwhile. A missing file is
/// made. Works between the nodes of a cluster where their file system has flock.
class FolderLock {
public:
  using Kind = platform::Lock;

  /// @param patience  how long to wait for the lock: the runs of a killed runner need a moment to end
  /// @throws InputOutputError if another process keeps the lock for longer, or the file cannot be written
  FolderLock(const std::filesystem::path& folder, Kind kind,
             std::chrono::milliseconds patience = std::chrono::seconds(5));
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

private:
  int m_descriptor;
};

} // namespace matrigrate::run
