#pragma once

#include <chrono>
#include <filesystem>

namespace matrigrate::run {

/// A lock on a file, which is made if need be: held until the end of this object and of all commands started while it
/// lives. Works between the nodes of a cluster where their file system has flock.
class FolderLock {
public:
  enum class Kind { alone, shared };

  /// @param patience  the lock is waited for so long: the runs of a runner that was killed need a moment to end
  /// @throws InputOutputError if others keep it for longer, or the file cannot be written
  FolderLock(const std::filesystem::path& folder, Kind kind,
             std::chrono::milliseconds patience = std::chrono::seconds(5));
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

private:
  int m_descriptor;
};

} // namespace matrigrate::run
