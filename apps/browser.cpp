#include "apps/browser.hpp"

#include "base/failure.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>

namespace matrigrate::apps {

namespace fs = std::filesystem;

fs::path page_of(const fs::path& folder) {
  std::error_code error;
  if (fs::is_regular_file(folder, error) && folder.extension() == ".html") return folder;
  if (fs::is_regular_file(folder / "report.html", error)) return folder / "report.html";
  if (!fs::is_directory(folder, error)) throw InputOutputError(fmt::format("{}: is no folder", folder.string()));
  fs::path newest;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const bool page = entry.path().extension() == ".html" && entry.path().filename().string().starts_with("report-");
    if (page && (newest.empty() || entry.last_write_time() > fs::last_write_time(newest))) newest = entry.path();
  }
  if (newest.empty())
    throw InputOutputError(fmt::format("{}: has no report.html; of a run or a study, `matrigrate report {}` makes it",
                                       folder.string(), folder.string()));
  return newest;
}

bool open_in_browser(const fs::path& page) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return false;
  std::string command = "xdg-open", argument = fs::absolute(page).string();
  const std::array<char*, 3> words{command.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) // what browsers print is of no interest
    ::posix_spawn_file_actions_addopen(&actions, descriptor, "/dev/null", O_RDWR, 0);
  pid_t process = -1;
  const bool started = ::posix_spawnp(&process, words[0], &actions, nullptr, words.data(), environ) == 0;
  ::posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  return started && ::waitpid(process, &status, 0) == process && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace matrigrate::apps
