#include "apps/run_output.hpp"
#include "apps/shipped_pages.hpp"
#include "apps/study/verbs.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/track_options.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "report/run_page.hpp"
#include "run/folder_state.hpp"
#include "study_report/drawn_study.hpp"
#include "tables/cell_tracks.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace matrigrate::apps {

namespace {

struct ReportArguments {
  std::string folder;
  std::vector<std::string> play;
  std::string tracks;
  TrackArguments reading;
};

/// The measured tracks that are to be drawn; none if no file is named.
std::vector<tracks::CellTrack> tracks_to_draw(const ReportArguments& options) {
  if (options.tracks.empty()) return {};
  std::vector<std::string> notes;
  auto tracks =
      tracks::measured_tracks(options.tracks, track_options(options.reading), tracks::TracksFor::drawing, notes);
  for (const std::string& note : notes) print(fmt::format("{}: {}\n", options.tracks, note));
  return tracks;
}

int report(const ReportArguments& options) {
  const std::filesystem::path folder = options.folder;
  const std::vector<tracks::CellTrack> tracks = tracks_to_draw(options);
  const run::FolderState state = run::look_at(folder);
  require(state, run::Use::see_either);
  if (state.has(run::Holds::a_study)) {
    const StudyFolder study = study::open_study(folder);
    Collected collected = gathered(study);
    require_no_loss(study, collected.results);
    if (const std::string fault = study::fault_of_wanted(collected.results, options.play); !fault.empty())
      throw UsageError(fault);
    study::write_study_report(study, collected,
                              {.page_template = study_page_template(), .played = options.play, .tracks = tracks});
  } else {
    if (!options.play.empty()) throw UsageError("--play is for studies: the report of a run plays that run");
    const FinishedRun run = read_run(folder);
    tell_lost_frames(run);
    auto page = page_data(run);
    page["measured"] = study::measured_json(tracks);
    write_file(folder / "report.html", report::filled_page(run_page_template(), page));
  }
  print(fmt::format("open {}\n", (folder / "report.html").string()));
  return done;
}

} // namespace

void add_report(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("report", "Make report.html of a run or a study anew, from its files");
  verb->footer(
      "Of a run: takes tables and protrusions from the last checkpoint, and the player's frames from\n"
      "fields.part or fields.h5; so it also works for a run that goes on, was killed, or was made without a\n"
      "report. Of a study: from the files of its runs; of up to five points it plays the run in the middle by\n"
      "the first read-out, unless --play names others. It draws the measured tracks that [[targets]] name.");
  const auto options = std::make_shared<ReportArguments>();
  verb->add_option("DIR", options->folder, "Folder of a run or a study")->required();
  verb->add_option("--play", options->play,
                   "A run that the page of a study is to play, by the name of its folder; may "
                   "be repeated")
      ->allow_extra_args(false);
  verb->add_option(
      "--tracks", options->tracks,
      "Measured tracks to draw over the simulated paths, each moved to their start: a file that matrigrate "
      "tracks reads, with the options of that verb");
  add_track_options(*verb, options->reading);
  verb->callback([options, &chosen] { chosen = [options] { return report(*options); }; });
}

} // namespace matrigrate::apps
