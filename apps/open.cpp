#include "apps/browser.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "run/folder_state.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace matrigrate::apps {

namespace {

namespace fs = std::filesystem;

/// The page of a folder: report.html, or the newest report-<ID>.html that `reproduce` wrote; a page itself.
/// @throws InputOutputError if there is none, saying how to make one
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

} // namespace

void add_open(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("open", "Open the page of a run, a study or `reproduce` in the browser");
  verb->footer("Opens report.html of the folder with xdg-open, or the newest report-<ID>.html that `reproduce` wrote.\n"
               "Where there is no screen, or no xdg-open, it prints where the page is.");
  const auto folder = std::make_shared<std::string>();
  const auto only_print = std::make_shared<bool>(false);
  verb->add_option("DIR", *folder, "Folder of a run, of a study or of `reproduce`; or a page itself")->required();
  verb->add_flag("--print", *only_print, "Only print where the page is");
  verb->callback([=, &chosen] {
    chosen = [=] {
      show_page(page_of(*folder), *only_print);
      return done;
    };
  });
}

} // namespace matrigrate::apps
