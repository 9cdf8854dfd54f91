#include "base/failure.hpp"
#include "base/platform.hpp"

#include <fmt/format.h>

#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <system_error>

namespace matrigrate::platform {

namespace {

namespace fs = std::filesystem;

constexpr const char* own_file = "MATRIGRATE_FILE"; // in the environment: what this program starts inherits it

/// Where the shell found a command.
fs::path found(const fs::path& command) {
  std::error_code ignored;
  if (command.has_parent_path()) return fs::absolute(command, ignored);
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path(folder) / command).c_str(), X_OK) == 0)
      return fs::absolute(fs::path(folder) / command, ignored);
  return {};
}

} // namespace

void begin(const char* called_as) { ::setenv(own_file, found(called_as == nullptr ? "" : called_as).c_str(), 1); }

void at_exit(void (* /*see*/)(int, void*)) {}

std::string this_program() { return program_file(); }

fs::path program_file() {
  const char* file = std::getenv(own_file);
  if (file == nullptr || *file == '\0')
    throw InputOutputError("the file of this program is not known; call it by its path");
  return file;
}

void end_with_parent() {}

bool catches(pid_t /*id*/, int /*signal*/, std::chrono::nanoseconds age) { return age > std::chrono::seconds(1); }

bool pass_on(pid_t id, int signal) { return ::kill(id, signal) == 0; }

int lock(int descriptor, Lock kind) {
  return ::flock(descriptor, (kind == Lock::alone ? LOCK_EX : LOCK_SH) | LOCK_NB) == 0 ? 0 : errno;
}

std::array<std::int64_t, 4> times_of(const struct stat& status) { return {status.st_mtime, 0, status.st_ctime, 0}; }

void give_back_memory() {}

std::string processor(std::string_view /*word*/) { return {}; }

} // namespace matrigrate::platform
