#include "apps/finished_run.hpp"
#include "apps/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/file.hpp"

#include <fmt/format.h>

#include <memory>

namespace matrigrate::apps {

namespace {

int report(const std::filesystem::path& folder) {
  write_file(folder / "report.html", report_of(read_run(folder)));
  print(fmt::format("open {}\n", (folder / "report.html").string()));
  return done;
}

} // namespace

void add_report(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("report", "Make report.html of a run anew, from its files");
  verb->footer("Takes tables and protrusions from the last checkpoint, and the player's frames from fields.part or\n"
               "fields.h5; so it also works for a run that goes on, was killed, or was made without a report.");
  const auto folder = std::make_shared<std::string>();
  verb->add_option("DIR", *folder, "Folder of a run")->required();
  verb->callback([folder, &chosen] { chosen = [folder] { return report(*folder); }; });
}

} // namespace matrigrate::apps
