#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Programs that exports call.
namespace matrigrate::apps {

bool is_installed(const std::string& program);

/// @throws InputOutputError naming the Debian package, if the program is not installed
void require_tool(const std::string& program, const std::string& purpose, const std::string& package);

/// Waits until the command has ended.
/// @throws InputOutputError if it fails
void call(const std::vector<std::string>& command);

/// A temporary folder, removed with its contents by the destructor. The folder of a killed process is removed when the
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
