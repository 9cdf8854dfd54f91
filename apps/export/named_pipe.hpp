#pragma once

#include "base/process.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace matrigrate::apps {

/// A pipe with a name in the file system, between this program and a child that opens it by that name.
class NamedPipe {
public:
  /// @throws InputOutputError if it cannot be made
  explicit NamedPipe(std::filesystem::path path);
  NamedPipe(const NamedPipe&) = delete;
  NamedPipe& operator=(const NamedPipe&) = delete;
  ~NamedPipe();

  const std::filesystem::path& path() const { return m_path; }

  /// Waits until the child has room for all of it.   @return false if the child has ended
  bool write(std::string_view bytes, Child& child);

  /// Waits for text of the child.   @return false if the child has ended and nothing is left
  bool read(std::string& append_to, Child& child);

  /// Waits until the child has read all of it, then lets it see the end. A child that starts slowly opens the pipe only
  /// after that, and a pipe that nobody holds open forgets what is in it.   @return false if the child has ended before
  bool finish(Child& child);

private:
  void close();

  std::filesystem::path m_path;
  int m_descriptor;
};

} // namespace matrigrate::apps
