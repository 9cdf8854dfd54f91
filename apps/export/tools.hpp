#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Programs that exports call.
namespace matrigrate::apps {

bool is_installed(const std::string& program);

/// Waits until the command has ended.
/// @param log  gets its output
/// @throws InputOutputError with the last line of its output, if it fails
void call(const std::vector<std::string>& command, const std::filesystem::path& log);

/// A folder that is gone with all that is in it at the end of this object. One whose process was killed goes when the
/// next one is made beside it.
struct TemporaryFolder {
  /// @throws InputOutputError if it cannot be made
  explicit TemporaryFolder(const std::filesystem::path& in);
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  std::filesystem::path path;

private:
  int m_lock = -1; ///< tells others that it is in use
};

} // namespace matrigrate::apps
