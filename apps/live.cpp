#include "apps/browser.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/platform.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace matrigrate::apps {

namespace {

namespace fs = std::filesystem;

struct LiveArguments {
  std::string copy;
  bool only_print = false;
};

/// Where the page may be: beside the installed program; in a wheel; where web/build.sh puts it; in the source archive
/// of a release; in a clone.
std::vector<std::string> places() {
  const fs::path folder = platform::program_file().parent_path();
  std::vector<std::string> all;
  for (const char* place : {"../share/matrigrate/live.html", "../live.html", "../../web/live/index.html",
                            "../../../pages/live.html", "../../../live/index.html"})
    all.push_back((folder / place).lexically_normal().string());
  return all;
}

fs::path live_page() {
  std::error_code error;
  for (const std::string& place : places())
    if (fs::is_regular_file(place, error)) return place;
  throw InputOutputError(fmt::format("the live page is not here: there is none of {}. A clone has it in live/; so have "
                                     "the Debian package, the wheel and "
                                     "the folder of a release",
                                     fmt::join(places(), ", ")));
}

int copy_page(const fs::path& page, const fs::path& file) {
  if (fs::exists(fs::symlink_status(file)))
    throw InputOutputError(file.string()
                           + ": exists and is not overwritten; choose another name, or delete the file first");
  std::error_code error;
  if (!fs::copy_file(page, file, error))
    throw InputOutputError(fmt::format("{}: cannot be written: {}", file.string(), error.message()));
  print(fmt::format("{}: the live page; open it in a browser, no network is needed\n", file.string()));
  return done;
}

int show_live(const LiveArguments& options) {
  const fs::path page = live_page();
  if (!options.copy.empty()) return copy_page(page, options.copy);
  show_page(page, options.only_print);
  return done;
}

} // namespace

void add_live(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("live", "Open the live page: a cell computed in the browser while you watch");
  verb->footer("The page is one file that needs no network: it may be copied and given to a class. It is opened with\n"
               "xdg-open; where there is no screen, or no xdg-open, its path is printed. A browser that may not read\n"
               "the folder of the page opens a copy: `matrigrate live -o live.html`.");
  const auto options = std::make_shared<LiveArguments>();
  auto* print_it = verb->add_flag("--print", options->only_print, "Only print where the page is");
  verb->add_option("-o,--output", options->copy, "Copy the page to this file instead; never overwrites one")
      ->excludes(print_it);
  verb->callback([options, &chosen] { chosen = [options] { return show_live(*options); }; });
}

} // namespace matrigrate::apps
