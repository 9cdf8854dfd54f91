#include "apps/export/tools.hpp"

#include "base/failure.hpp"
#include "base/process.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <thread>

namespace matrigrate::apps {

bool is_installed(const std::string& program) {
  if (program.find('/') != std::string::npos) return ::access(program.c_str(), X_OK) == 0;
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

void call(const std::vector<std::string>& command, const std::filesystem::path& log) {
  const int output = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, S_IRUSR | S_IWUSR);
  Child child(command, output >= 0 ? output : STDERR_FILENO);
  if (output >= 0) ::close(output);
  std::optional<int> code;
  while (!(code = child.ended())) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  if (*code == 0) return;
  std::ifstream said(log);
  std::string last;
  for (std::string line; std::getline(said, line);)
    if (!line.empty()) last = line;
  throw InputOutputError(last.empty() ? fmt::format("{} ended with exit code {}", command.front(), *code) : last);
}

namespace {

/// Removes what a movie has left whose process was killed: nobody holds its lock any longer.
void remove_left_behind(const std::filesystem::path& in) {
  std::error_code error;
  for (std::filesystem::directory_iterator it(in, error); !error && it != std::filesystem::directory_iterator();
       it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.size() != std::string_view(".movie.XXXXXX").size() || !name.starts_with(".movie.")) continue;
    const int lock = ::open(it->path().c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (lock < 0) continue;
    std::error_code ignored;
    if (::flock(lock, LOCK_EX | LOCK_NB) == 0) std::filesystem::remove_all(it->path(), ignored);
    ::close(lock);
  }
}

} // namespace

TemporaryFolder::TemporaryFolder(const std::filesystem::path& in) {
  remove_left_behind(in);
  std::string name = (std::filesystem::absolute(in) / ".movie.XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw InputOutputError(
        fmt::format("{}: cannot be written: {}", in.string(), std::generic_category().message(errno)));
  path = name;
  m_lock = ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (m_lock >= 0) ::flock(m_lock, LOCK_EX); // until it ends, however it ends
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
  if (m_lock >= 0) ::close(m_lock);
}

} // namespace matrigrate::apps
