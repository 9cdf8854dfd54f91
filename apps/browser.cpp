#include "apps/browser.hpp"

#include "base/failure.hpp"
#include "base/process.hpp"
#include "run/folder_state.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace matrigrate::apps {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

fs::path page_of(const fs::path& folder) {
  std::error_code error;
  if (fs::is_regular_file(folder, error) && folder.extension() == ".html") return folder;
  if (fs::is_regular_file(folder / "report.html", error)) return folder / "report.html";
  require(run::look_at(folder), run::Use::see_files);
  fs::path newest;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const bool page = entry.path().extension() == ".html" && entry.path().filename().string().starts_with("report-");
    if (page && (newest.empty() || entry.last_write_time() > fs::last_write_time(newest))) newest = entry.path();
  }
  if (newest.empty())
    throw InputOutputError(fmt::format("{}: has no report.html; for a run or a study, `matrigrate report {}` writes it",
                                       folder.string(), folder.string()));
  return newest;
}

bool open_in_browser(const fs::path& page) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return false;
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); // what browsers print is of no interest
  Child opener({"xdg-open", fs::absolute(page).string()}, nowhere);
  ::close(nowhere);
  while (!opener.ended()) std::this_thread::sleep_for(20ms);
  return opener.ended() == 0;
}

} // namespace matrigrate::apps
