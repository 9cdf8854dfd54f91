#include "apps/browser.hpp"
#include "apps/run_output.hpp"
#include "apps/shipped_pages.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/file.hpp"
#include "parameters/presets.hpp"
#include "parameters/read.hpp"
#include "run/folder_state.hpp"
#include "simulation/start.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace matrigrate::apps {

namespace {

struct DemoArguments {
  std::string folder;
  std::string preset = "baseline";
  double hours = 3.0;
  bool no_open = false;
  std::vector<std::string> command_line;
};

/// The first of matrigrate-demo, matrigrate-demo-2, ... that does not exist: earlier results are never overwritten.
std::filesystem::path free_folder() {
  std::filesystem::path folder = "matrigrate-demo";
  for (int n = 2; std::filesystem::exists(std::filesystem::symlink_status(folder)); ++n)
    folder = fmt::format("matrigrate-demo-{}", n);
  return folder;
}

int demonstrate(const DemoArguments& options) {
  const Parameters p = apply_overrides(parameters_of(preset_named(options.preset)),
                                       {fmt::format("run.duration={} h", options.hours)}, start_rules());
  const std::filesystem::path folder = options.folder.empty() ? free_folder() : std::filesystem::path(options.folder);
  print_error(fmt::format("{} of a cell that migrates through a gel of {:.0f} Pa, into {}/\n",
                          fmt::format("{:g} hours", options.hours), 1e3 * p.ecm.youngs_modulus, folder.string()));
  require(run::look_at(folder), run::Use::pictures);
  make_folder(folder);
  RunStart start{.s = initial_state(p), .p = p};
  start.scenario = options.preset;
  RunDisplay display(false);
  const RunOutcome outcome =
      run::run(std::move(start),
               {.folder = folder, .command_line = options.command_line, .page_template = run_page_template()}, display);
  const int code = print_outcome(outcome, {});
  if (code == done && !options.no_open) open_in_browser(folder / "report.html");
  return code;
}

} // namespace

void add_demo(CLI::App& app, Action& chosen, std::vector<std::string> command_line) {
  CLI::App* verb = app.add_subcommand("demo", "Simulate a cell for three hours, in about 20 s, and open its page");
  verb->footer(
      "Needs no scenario file. The page plays the cell and the matrix; it is opened with xdg-open where there is a\n"
      "screen. `matrigrate new cell.toml` writes a scenario to change.");
  const auto options = std::make_shared<DemoArguments>();
  options->command_line = std::move(command_line);
  verb->add_option("-o,--output", options->folder, "Folder for the results (default: matrigrate-demo, or -2, -3, ...)");
  verb->add_option("--preset", options->preset, "What is simulated: see `matrigrate list` (default: baseline)");
  verb->add_option("--hours", options->hours, "Simulated time in hours (default: 3)");
  verb->add_flag("--no-open", options->no_open, "Do not open the page");
  verb->callback([options, &chosen] { chosen = [options] { return demonstrate(*options); }; });
}

} // namespace matrigrate::apps
