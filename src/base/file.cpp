#include "base/file.hpp"

#include "base/failure.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace matrigrate {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view reason) {
  throw InputOutputError(fmt::format("{}: {}", path.string(), reason));
}

[[noreturn]] void fail_with(const std::filesystem::path& path, std::string_view what, int error) {
  fail(path, fmt::format("{}: {}", what, std::generic_category().message(error)));
}

/// An open file descriptor, closed at the end of its scope.
class Descriptor {
public:
  explicit Descriptor(int number) : m_number(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (m_number >= 0) ::close(m_number);
  }
  int number() const { return m_number; }
  /// Closes now, so that an error on closing can be reported. @return 0, or the error
  int close() {
    const int status = ::close(m_number);
    m_number = -1;
    return status == 0 ? 0 : errno;
  }

private:
  int m_number;
};

/// @return 0, or the error
int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Removes the temporary file unless it was renamed to its final name.
struct Temporary {
  std::string path;
  bool kept = false;
  ~Temporary() {
    if (!kept) ::unlink(path.c_str());
  }
};

} // namespace

std::optional<std::string> file_of_temporary(const std::string& name) {
  constexpr std::size_t random = 6; // characters of mkstemp
  const auto is_random = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  if (name.size() < random + 3 || name.front() != '.' || name[name.size() - random - 1] != '.') return std::nullopt;
  if (!std::all_of(name.end() - random, name.end(), is_random)) return std::nullopt;
  return name.substr(1, name.size() - random - 2);
}

void write_file(const std::filesystem::path& path, std::string_view content) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) fail(path, "is a folder, not a file");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) fail(path, "is not a regular file");
  Temporary temporary{path.parent_path() / fmt::format(".{}.XXXXXX", path.filename().string())};
  Descriptor file(::mkstemp(temporary.path.data()));
  if (file.number() < 0) {
    temporary.kept = true; // nothing was made
    fail_with(path, "cannot be written", errno);
  }
  if (const int error = write_all(file.number(), content)) fail_with(path, "cannot be written", error);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(file.number(), 0666 & ~mask) != 0) fail_with(path, "cannot be written", errno);
  if (::fsync(file.number()) != 0) fail_with(path, "cannot be flushed to disk", errno);
  if (const int error = file.close()) fail_with(path, "cannot be closed", error);
  // The folder is not flushed: after a power cut the file of before may be there, whole.
  if (::rename(temporary.path.c_str(), path.c_str()) != 0) fail_with(path, "cannot be written", errno);
  temporary.kept = true;
}

GrowingFile::GrowingFile(std::filesystem::path path, std::string_view content)
    : m_path(std::move(path)), m_size(static_cast<std::int64_t>(content.size())) {
  write_file(m_path, content);
  m_descriptor = ::open(m_path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (m_descriptor < 0) fail_with(m_path, "cannot be written", errno);
}

GrowingFile::~GrowingFile() { ::close(m_descriptor); }

void GrowingFile::append(std::string_view piece) {
  if (const int error = write_all(m_descriptor, piece)) {
    // Where a part of it cannot be taken back either, the first error is the one to tell.
    [[maybe_unused]] const int second = ::ftruncate(m_descriptor, m_size);
    fail_with(m_path, "cannot be written", error);
  }
  m_size += static_cast<std::int64_t>(piece.size());
}

void GrowingFile::flush() const {
  if (::fsync(m_descriptor) != 0) fail_with(m_path, "cannot be flushed to disk", errno);
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) fail_with(to, "cannot be written", errno);
  const std::filesystem::path folder = to.has_parent_path() ? to.parent_path() : std::filesystem::path(".");
  const Descriptor entries(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (entries.number() >= 0) ::fsync(entries.number()); // some file systems cannot, and need not
}

namespace {

/// Opens a regular file. @param size  its bytes out
int open_regular(const std::filesystem::path& path, std::size_t& size) {
  // Without O_NONBLOCK, opening a named pipe would wait for its writer.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) fail_with(path, "cannot be read", errno);
  struct stat status {};
  const int error = ::fstat(descriptor, &status) == 0 ? 0 : errno;
  if (error == 0 && S_ISREG(status.st_mode)) {
    size = static_cast<std::size_t>(status.st_size);
    return descriptor;
  }
  ::close(descriptor);
  if (error != 0) fail_with(path, "cannot be read", error);
  fail(path, S_ISDIR(status.st_mode) ? "is a folder, not a file" : "is not a regular file");
}

} // namespace

std::string read_start(const std::filesystem::path& path, std::size_t bytes) {
  std::size_t size = 0;
  const Descriptor file(open_regular(path, size));
  std::string start(std::min(size, bytes), '\0');
  std::size_t filled = 0;
  while (filled < start.size()) {
    const ssize_t got = ::read(file.number(), start.data() + filled, start.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_with(path, "cannot be read", errno);
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
  }
  start.resize(filled);
  return start;
}

std::string read_file(const std::filesystem::path& path, std::size_t max_bytes) {
  std::size_t size = 0;
  const Descriptor file(open_regular(path, size));
  if (size > max_bytes) fail(path, fmt::format("has {} bytes, more than the {} allowed", size, max_bytes));

  std::string content;
  std::size_t filled = 0;
  do {
    content.resize(std::max(filled + 4096, size + 1)); // room to see that nothing follows, also if the file grows
    const ssize_t got = ::read(file.number(), content.data() + filled, content.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_with(path, "cannot be read", errno);
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
  } while (filled <= max_bytes);
  if (filled > max_bytes) fail(path, fmt::format("has more than the {} bytes allowed", max_bytes));
  content.resize(filled);
  return content;
}

namespace {

/// Locks, and what a killed writer has left.
} // namespace

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status)) return;
  if (std::filesystem::exists(status)) fail(path, "exists and is not a folder");
  std::filesystem::create_directories(path, error);
  if (error) fail(path, "cannot be made: " + error.message());
}

std::filesystem::path temporary_folder() {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (!error) return folder;
  const char* named = std::getenv("TMPDIR");
  fail(named == nullptr ? "/tmp" : named, "is no folder to work in: " + error.message() + "; TMPDIR names another one");
}

} // namespace matrigrate
