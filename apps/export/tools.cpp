#include "apps/export/tools.hpp"

#include "base/failure.hpp"
#include "study_runs/child.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <sstream>
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

void require_tool(const std::string& program, const std::string& purpose, const std::string& package) {
  if (!is_installed(program))
    throw InputOutputError(fmt::format("{} is needed for {}; Debian: apt-get install {}", program, purpose, package));
}

void call(const std::vector<std::string>& command) {
  study::Child child(command, STDERR_FILENO);
  std::optional<int> code;
  while (!(code = child.ended())) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  if (*code != 0) throw InputOutputError(fmt::format("{} ended with exit code {}", command.front(), *code));
}

TemporaryFolder::TemporaryFolder(const std::filesystem::path& in) {
  std::string name = (std::filesystem::absolute(in) / ".movie.XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw InputOutputError(
        fmt::format("{}: cannot be written: {}", in.string(), std::generic_category().message(errno)));
  path = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

} // namespace matrigrate::apps
