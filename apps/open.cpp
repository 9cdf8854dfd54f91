#include "apps/browser.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>

namespace matrigrate::apps {

namespace {

int open_page(const std::string& folder, bool only_print) {
  const std::filesystem::path page = page_of(folder);
  if (only_print || !open_in_browser(page))
    print(
        fmt::format("{}{}\n", only_print ? "" : "open ", std::filesystem::absolute(page).lexically_normal().string()));
  return done;
}

} // namespace

void add_open(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("open", "Open the page of a run, a study or `reproduce` in the browser");
  verb->footer("Opens report.html of the folder with xdg-open, or the newest report-<ID>.html that `reproduce` wrote.\n"
               "Where there is no screen, or no xdg-open, it prints where the page is.");
  const auto folder = std::make_shared<std::string>();
  const auto only_print = std::make_shared<bool>(false);
  verb->add_option("DIR", *folder, "Folder of a run, of a study or of `reproduce`; or a page itself")->required();
  verb->add_flag("--print", *only_print, "Only print where the page is");
  verb->callback([=, &chosen] { chosen = [=] { return open_page(*folder, *only_print); }; });
}

} // namespace matrigrate::apps
