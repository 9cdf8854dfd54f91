#pragma once

#include "base/failure.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace matrigrate {

/// Writes a file atomically: hidden temporary file in the same folder, flushed to disk, renamed. Each step is checked.
/// @throws InputOutputError naming the path and the reason
void write_file(const std::filesystem::path& path, std::string_view content);

/// The target of a temporary file of write_file(): "f" for ".f.a1B2c3"; none for other names.
std::optional<std::string> file_of_temporary(const std::string& name);

/// An append-only file for programs that may be killed at any moment: it holds complete pieces, except for one that a
/// crash has truncated.
class GrowingFile {
public:
  /// Creates the file with the existing content, replacing an old one atomically.
  /// @throws InputOutputError naming the path and the reason
  GrowingFile(std::filesystem::path path, std::string_view content);
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();

  /// Appends a piece and passes it to the system at once. A piece that does not fit on the disk is removed again.
  /// @throws InputOutputError naming the path and the reason
  void append(std::string_view piece);

  /// Waits until all pieces are on the disk.
  /// @throws InputOutputError naming the path and the reason
  void flush() const;

private:
  std::filesystem::path m_path;
  int m_descriptor = -1;
  std::int64_t m_size; ///< of the complete pieces [bytes]
};

/// What `call` returns.   @throws InputOutputError as it does, with the file named in front
template <class Call>
auto naming(const std::filesystem::path& file, const Call& call) {
  try {
    return call();
  } catch (const InputOutputError& trouble) {
    throw InputOutputError(file.string() + ": " + trouble.what());
  }
}

/// Renames a file atomically, replacing an existing file of the new name: also after a crash there is one or the other.
/// @throws InputOutputError naming the path and the reason
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Reads the whole file.
/// @throws InputOutputError if it cannot be read, is no regular file, or is larger than max_bytes
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Reads the first bytes of a file, fewer where it is shorter.
/// @throws InputOutputError as read_file
std::string read_start(const std::filesystem::path& path, std::size_t bytes);

/// Creates a folder, and those above it, where there is none.
/// @throws InputOutputError naming the path and the reason
void make_folder(const std::filesystem::path& path);

/// The folder for what is not to be kept: TMPDIR, or the system's.
/// @throws InputOutputError if there is no such folder
std::filesystem::path temporary_folder();

} // namespace matrigrate
