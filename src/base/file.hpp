#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace matrigrate {

/// Writes the file whole or not at all: hidden temporary file beside it, flushed to disk, renamed. Each step is
/// checked.
/// @throws InputOutputError naming the path and the reason
void write_file(const std::filesystem::path& path, std::string_view content);

/// The file that a temporary file of write_file() was to become: "f" for ".f.a1B2c3"; none for other names.
std::optional<std::string> file_of_temporary(const std::string& name);

/// A file that grows by pieces, for programs that may be ended at any moment: it holds whole pieces, but for one that a
/// crash has cut short.
class GrowingFile {
public:
  /// Makes the file anew with what there is already; it is replaced as a whole or not at all.
  /// @throws InputOutputError naming the path and the reason
  GrowingFile(std::filesystem::path path, std::string_view content);
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;
  ~GrowingFile();

  /// Appends a piece and hands it to the system at once; one that does not fit on the disk is taken back.
  /// @throws InputOutputError naming the path and the reason
  void append(std::string_view piece);

  /// Waits until all of it is on the disk.
  /// @throws InputOutputError naming the path and the reason
  void flush() const;

private:
  std::filesystem::path m_path;
  int m_descriptor = -1;
  std::int64_t m_size; ///< of the whole pieces [bytes]
};

/// Renames a file, replacing one of the new name, so that there is one or the other at any time, also after a crash.
/// @throws InputOutputError naming the path and the reason
void rename_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Reads the whole file.
/// @throws InputOutputError if it cannot be read, is no regular file, or is larger than max_bytes
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Makes a new folder for results. An existing one that is not empty, hidden files aside, is refused unless `force`;
/// nothing is ever deleted.
/// @throws InputOutputError naming the path and the reason
void make_output_folder(const std::filesystem::path& path, bool force);

} // namespace matrigrate
