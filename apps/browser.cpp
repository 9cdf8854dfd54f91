#include "apps/browser.hpp"

#include "apps/terminal/terminal.hpp"
#include "base/process.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace matrigrate::apps {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

bool open_in_browser(const fs::path& page) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return false;
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); // what browsers print is of no interest
  Child opener({"xdg-open", fs::absolute(page).string()}, nowhere);
  ::close(nowhere);
  while (!opener.ended()) std::this_thread::sleep_for(20ms);
  return opener.ended() == 0;
}

void show_page(const fs::path& page, bool only_print) {
  if (only_print || !open_in_browser(page))
    print(fmt::format("{}{}\n", only_print ? "" : "open ", fs::absolute(page).lexically_normal().string()));
}

} // namespace matrigrate::apps
