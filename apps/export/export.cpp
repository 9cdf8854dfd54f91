#include "apps/export/other_programs.hpp"
#include "apps/run_output.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "exchange/run_tracks.hpp"
#include "parameters/units.hpp"
#include "run/folder_state.hpp"
#include "run/own_files.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"
#include "store/field_file.hpp"
#include "study_results/results.hpp"
#include "study_runs/study_folder.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace matrigrate::apps {

namespace {

/// The parts of a list between commas, without the spaces around them; none of an empty text.
std::vector<std::string> items_of(const std::string& list) {
  std::vector<std::string> items;
  std::istringstream in(list.empty() ? list : list + ','); // so that nothing behind the last comma is a part, too
  for (std::string text; std::getline(in, text, ',');) {
    const std::size_t begin = text.find_first_not_of(' ');
    items.push_back(begin == std::string::npos ? std::string()
                                               : text.substr(begin, text.find_last_not_of(' ') + 1 - begin));
  }
  return items;
}

/// A time with its unit, "1 h 30 min"; 0 needs none [s].
/// @throws std::invalid_argument saying what is wrong
double time_of(const std::string& text) {
  if (text.empty()) throw std::invalid_argument("is no time: nothing stands between two commas, or behind the last");
  const units::Quantity quantity = units::parse_quantity(text);
  const bool zero = units::to_internal(quantity.number, units::parse_unit("1")) == 0.0;
  if (quantity.unit.empty() && !zero)
    throw std::invalid_argument(fmt::format("has no unit; write {0} s, {0} min or {0} h", quantity.number));
  const units::Unit unit = units::parse_unit(quantity.unit.empty() ? "s" : quantity.unit);
  if (unit.dimension != units::Dimension{.time = 1000}) throw std::invalid_argument("is no time");
  return units::to_internal(quantity.number, unit);
}

constexpr std::string_view every = "every ";
constexpr std::string_view example = "an example: --times \"every 10 min\", or --times \"0 h, 1 h, 3 h\"";

/// The rows before the last time.
std::vector<TrackRow> without_last(std::vector<TrackRow> rows) {
  const double last = rows.back().t;
  std::erase_if(rows, [&](const TrackRow& row) { return row.t >= last; });
  return rows;
}

/// The day of "2026-01-31T12:00:00Z".
std::string day_of(const std::string& time) { return time.substr(0, 10); }

/// The times that --times names: "every 10 min", "0 h, 1 h, 3 h", or none: all.
/// @throws UsageError naming all that cannot be read
exchange::Times wanted_times(const std::string& text) {
  exchange::Times times;
  const bool regular = text.starts_with(every);
  std::vector<std::string> faults;
  for (const std::string& item : regular ? std::vector{text.substr(every.size())} : items_of(text)) try {
      const double t = time_of(item);
      if (t < 0.0 || (regular && t == 0.0)) throw std::invalid_argument(regular ? "is not above 0" : "is below 0");
      if (!times.list.empty() && t <= times.list.back())
        throw std::invalid_argument("does not come after the time before it");
      times.list.push_back(t);
    } catch (const std::invalid_argument& fault) {
      faults.push_back(fmt::format("\"{}\": {}", item, fault.what()));
    }
  if (!faults.empty()) throw UsageError(fmt::format("--times: {}; {}", fmt::join(faults, "; "), example));
  if (regular) times = {.every = times.list.front(), .list = {}};
  return times;
}

/// The tracks of a run, as those of a study of one run.
exchange::RunTracks single_run(const run::FinishedRun& run) {
  const std::string name = scenario_name(run.record, run.folder);
  return {.name = name, .condition = name, .replicate = 1, .seed = run.p.run.seed, .rows = run.memory.rows};
}

/// The runs at these times.
/// @throws UsageError naming all runs and times that they lack
std::vector<exchange::RunTracks> at_times(std::vector<exchange::RunTracks> runs, const exchange::Times& times) {
  std::vector<std::string> faults;
  for (exchange::RunTracks& run : runs) try {
      run.rows = exchange::rows_at(run, times);
    } catch (const std::invalid_argument& fault) {
      faults.emplace_back(fault.what());
    }
  if (!faults.empty()) throw UsageError(fmt::format("--times: {}", fmt::join(faults, "\n")));
  return runs;
}

/// What makes rows or frames evenly spaced, in a sentence.
/// @param interval  "output.track_interval"
std::string even_if(std::string_view interval, const Parameters& p) {
  return fmt::format("they are evenly spaced where {} is a multiple of run.time_step, {:g} s", interval,
                     p.run.time_step);
}

/// tracks_celltrackr.csv, tracks_trackmate.csv and tracks_trackmate.xml of a run. Warns of what the files for TrackMate
/// leave out where rows are not evenly spaced.
void write_tracks(const run::FinishedRun& run, const std::filesystem::path& to) {
  write_file(to / "tracks_celltrackr.csv", exchange::celltrackr_csv(run.memory.rows));
  std::vector<TrackRow> rows = run.memory.rows;
  const observe::EvenTimes times = observe::even_times(observe::times_of(rows));
  if (times.but_the_last()) {
    print_warning(fmt::format("the last position, at {:g} s, comes sooner than {:g} s after the one before it: the "
                              "files for TrackMate leave it out",
                              rows.back().t, times.interval));
    rows = without_last(rows);
  }
  write_file(to / "tracks_trackmate.csv", exchange::trackmate_csv(rows));
  if (times.is_even() || times.but_the_last())
    return write_file(to / "tracks_trackmate.xml", exchange::trackmate_xml(rows));
  print_warning(fmt::format("tracks_trackmate.xml is not written, and tracks_trackmate.csv has no FRAME: the positions "
                            "are {}, and TrackMate counts frames of one interval; {}",
                            times.text(), even_if("output.track_interval", run.p)));
}

/// The runs without last rows that come too soon. Warns of them, and of runs whose rows are uneven otherwise.
std::vector<exchange::RunTracks> without_odd_ends(std::vector<exchange::RunTracks> runs) {
  std::size_t odd = 0, uneven = 0;
  for (exchange::RunTracks& run : runs) {
    const observe::EvenTimes times = observe::even_times(observe::times_of(run.rows));
    if (times.but_the_last()) {
      run.rows = without_last(run.rows);
      ++odd;
    } else if (!times.is_even()) {
      ++uneven;
    }
  }
  if (odd > 0)
    print_warning(fmt::format("the last positions of {} of {} runs come too soon after those before them: "
                              "tracks_spots.csv leaves them out",
                              odd, runs.size()));
  if (uneven > 0)
    print_warning(fmt::format("the positions of {} of {} runs are not evenly spaced: tracks_spots.csv has no FRAME, "
                              "which counts frames of one interval",
                              uneven, runs.size()));
  return runs;
}

/// openvt.csv, openvt.json, openvt_simulator.json.
/// @param runs  at the times that are wanted
void write_openvt(const std::vector<exchange::RunTracks>& runs, exchange::OpenVtModel model,
                  const std::filesystem::path& to) {
  model.version = run::version_text();
  write_file(to / "openvt.csv", exchange::openvt_csv(runs));
  write_file(to / "openvt.json", exchange::openvt_record(model, runs));
  write_file(to / "openvt_simulator.json", exchange::openvt_simulator(model.version));
}

/// What openvt.json says of a run, and of a study.
exchange::OpenVtModel openvt_model(const run::FinishedRun& run) {
  const std::string end = run::text_of(run.record, "end");
  return {.title = run::run_title(run.p, scenario_name(run.record, run.folder)),
          .version = {},
          .updated = day_of(end.empty() ? run::text_of(run.record, "start") : end),
          .base = run.p};
}

exchange::OpenVtModel openvt_model(const study::Study& study, const std::vector<study::Result>& results) {
  std::string last;
  for (const study::Result& result : results) last = std::max(last, result.standing.end);
  return {.title = study.title, .version = {}, .updated = day_of(last), .base = study.base};
}

/// The frame nearest to a time. Warns where it is not at that time.
/// @throws UsageError if there is none nearby
std::size_t frame_at(const run::FinishedRun& run, double t, std::string_view option) {
  const std::vector<observe::Frame>& frames = run.film.frames;
  const auto nearest = std::ranges::min_element(frames, {}, [&](const observe::Frame& f) { return std::abs(f.t - t); });
  if (std::abs(nearest->t - t) > 0.5 * run.p.output.field_interval + 1.0)
    throw UsageError(fmt::format("{}: there is no frame at {}: the frames of {} are from {} to {}, {} apart", option,
                                 time_text(t), run.folder.string(), time_text(frames.front().t),
                                 time_text(frames.back().t), time_text(run.p.output.field_interval)));
  constexpr double same = 0.5; // a frame of a run that was stopped may be a step off [s]
  if (std::abs(nearest->t - t) > same)
    print_warning(fmt::format("{}: there is no frame at {}; the nearest is taken, at {}", option, time_text(t),
                              time_text(nearest->t)));
  return static_cast<std::size_t>(nearest - frames.begin());
}

/// The times of the frames of a run nearest to those of --panel [s].
/// @param times  "0 h, 1 h 30 min, 6 h"
/// @throws UsageError saying what cannot be read, or which time has no frame nearby
std::vector<double> panel_times(const run::FinishedRun& run, const std::string& times) {
  constexpr std::string_view panel_example = "an example: --panel \"0 h, 1 h, 3 h, 6 h\"";
  std::vector<double> chosen;
  for (const std::string& text : items_of(times)) try {
      chosen.push_back(run.film.frames[frame_at(run, time_of(text), "--panel")].t);
    } catch (const std::invalid_argument& fault) {
      throw UsageError(fmt::format("--panel: \"{}\": {}; {}", text, fault.what(), panel_example));
    }
  if (chosen.empty()) throw UsageError(fmt::format("--panel: names no time; {}", panel_example));
  return chosen;
}

/// The numbers of the frames nearest to those of --times, each once; all without times.
/// @throws UsageError saying which time has no frame nearby
std::vector<std::size_t> frames_at(const run::FinishedRun& run, const exchange::Times& times) {
  const std::vector<observe::Frame>& frames = run.film.frames;
  std::vector<double> wanted = times.list;
  if (times.every)
    for (std::size_t k = 0; static_cast<double>(k) * *times.every <= frames.back().t; ++k)
      wanted.push_back(static_cast<double>(k) * *times.every);
  std::vector<std::size_t> chosen;
  for (const double t : wanted) chosen.push_back(frame_at(run, t, "--times"));
  if (wanted.empty())
    for (std::size_t k = 0; k < frames.size(); ++k) chosen.push_back(k);
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

struct ExportArguments {
  std::string folder;
  std::string output;
  std::string panel; ///< times; empty: no panel
  std::string times; ///< of --openvt and --png; empty: all
  std::string pixel; ///< of --ome-tiff; empty: the spacing of the particles
  DrawnOptions drawn;
  std::map<std::string, bool, std::less<>> wanted; ///< by the option of the kind: "--png"
  bool force = false;
};

/// What earlier versions exported, and what stands for it.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> gone_kinds{{
    {"--svg",
     "--panel \"0 h, 1 h, 3 h\" draws frames side by side as SVG, --png each frame as PNG and SVG, and in Python "
     "matrigrate.plot.path the path"},
    {"--vtk", "ParaView and PyVista open fields.xdmf of the run; --fields writes it of a run that is not done yet"},
}};

/// @throws UsageError if nothing is wanted, or what has gone, naming what stands for it
std::vector<ExportKind> wanted_kinds(const ExportArguments& options) {
  for (const auto& [option, instead] : gone_kinds)
    if (options.wanted.find(option)->second) throw UsageError(fmt::format("{}: has gone: {}", option, instead));
  std::vector<ExportKind> kinds;
  std::ranges::copy_if(export_kinds(), std::back_inserter(kinds),
                       [&](const ExportKind& kind) { return options.wanted.find(kind.option)->second; });
  if (kinds.empty())
    throw UsageError("say what to export: --fields, --tracks, --openvt, --simularium, --ome-tiff, --png, --movie "
                     "or --panel");
  return kinds;
}

void require_frames(const FinishedRun& run, const std::string& folder) {
  if (!run.film.frames.empty()) return;
  const bool kept = run.p.output.field_interval > 0.0;
  throw InputOutputError(fmt::format("{}: holds no frames: {}", folder,
                                     kept ? "neither fields.part nor fields.h5 has a complete frame"
                                          : "the run was made with output.field_interval = 0"));
}

/// Simularium's viewer supposes frames of one interval.
void require_even_frames(const FinishedRun& run, const std::string& folder) {
  const observe::EvenTimes times = observe::even_times(observe::times_of(run.film));
  if (!times.is_even() && !times.but_the_last())
    throw InputOutputError(fmt::format("{}: its frames are {}, and Simularium's viewer supposes one interval; {}",
                                       folder, times.text(), even_if("output.field_interval", run.p)));
  if (!times.is_even())
    print_warning(fmt::format("the last frame, at {:g} s, comes sooner than {:g} s after the one before it: "
                              "run.simularium leaves it out",
                              run.film.frames.back().t, times.interval));
}

/// Makes room for what is exported: other kinds in the folder stay, the same kind is replaced if `force`.
void prepare(const std::filesystem::path& to, const std::vector<ExportKind>& kinds, bool force) {
  require(run::look_at(to), run::Use::exports);
  for (const ExportKind& kind : kinds)
    if (const auto files = files_of(kind, to); !files.empty() && !force)
      throw InputOutputError(fmt::format("{}: exists; {} --force replaces this kind of export, -o FOLDER writes it "
                                         "somewhere else",
                                         files.front().string(), kind.option));
  make_folder(to);
  for (const ExportKind& kind : kinds) std::ranges::for_each(files_of(kind, to), remove_file);
}

void export_fields(const FinishedRun& run, const std::filesystem::path& to) {
  const auto hash = run.record.find("trajectory_hash");
  const bool finished = hash != run.record.end() && hash->is_string();
  store::write_field_files(to, run.film, field_origin(run.p, finished ? hash->get<std::string>() : std::string()));
}

constexpr double most_pixels = 8192; ///< along an edge of a stack

/// The width of a pixel that --pixel names [um]; none without one.
/// @throws UsageError if it is none, or makes too large pictures
std::optional<double> pixel_of(const std::string& text, const observe::FrameHead& head) {
  if (text.empty()) return {};
  double pixel = 0.0;
  try {
    const units::Quantity quantity = units::parse_quantity(text);
    const units::Unit unit = units::parse_unit(quantity.unit.empty() ? "um" : quantity.unit);
    if (unit.dimension != units::parse_unit("um").dimension) throw std::invalid_argument("is no length");
    pixel = units::to_internal(quantity.number, unit);
  } catch (const std::invalid_argument& fault) {
    throw UsageError(fmt::format("--pixel: \"{}\": {}; an example: --pixel \"0.5 um\"", text, fault.what()));
  }
  const double least = 2.0 * head.radius / most_pixels;
  if (!(pixel >= least && pixel <= head.radius))
    throw UsageError(fmt::format("--pixel: {}: allowed are {:.3g} to {:g} um, for {} to 2 pixels along an edge", text,
                                 least, head.radius, most_pixels));
  return pixel;
}

std::filesystem::path output_of(const ExportArguments& options) {
  return options.output.empty() ? std::filesystem::path(options.folder) / "export"
                                : std::filesystem::path(options.output);
}

/// The tracks of all runs of a study that are done.
int export_study(const ExportArguments& options) {
  const exchange::Times times = wanted_times(options.times);
  const study::StudyFolder study = study::open_study(options.folder);
  const std::vector<study::Result> results = study::results(study.study, study.runs, study.folder);
  for (const study::Result& r : results)
    if (r.standing.status == study::RunState::damaged)
      throw InputOutputError(fmt::format("{}: runs/{} is damaged: {}", options.folder, r.run.hash, r.standing.reason));
  const auto runs = std::ranges::count_if(results, [](const study::Result& r) { return r.standing.done(); });
  if (runs == 0)
    throw InputOutputError(fmt::format("{0}: none of its {1} runs is done; matrigrate study run "
                                       "{0}/study.resolved.toml computes them",
                                       options.folder, results.size()));
  const std::string text = study::tracks_csv(study.study, results, study.folder);
  const std::vector<exchange::RunTracks> tracks = study::run_tracks(study.study, results, study.folder);
  const bool openvt = options.wanted.find("--openvt")->second, table = options.wanted.find("--tracks")->second;
  const std::vector<exchange::RunTracks> at = openvt ? at_times(tracks, times) : std::vector<exchange::RunTracks>();
  const std::filesystem::path to = output_of(options);
  std::vector<ExportKind> kinds;
  if (table) kinds.push_back({.option = "--tracks", .names = R"(tracks(_spots|_tracks)?\.csv)"});
  if (openvt) kinds.push_back(*std::ranges::find(export_kinds(), "--openvt", &ExportKind::option));
  prepare(to, kinds, options.force);
  if (table) {
    write_file(to / "tracks.csv", text);
    const std::vector<exchange::RunTracks> even = without_odd_ends(tracks);
    write_file(to / "tracks_spots.csv", exchange::spots_csv(even));
    write_file(to / "tracks_tracks.csv", exchange::tracks_csv(even));
  }
  if (openvt) write_openvt(at, openvt_model(study.study, results), to);
  print(fmt::format("exported the tracks of {} of {} runs to {}\n", runs, results.size(),
                    (to / (table ? "tracks.csv" : "openvt.csv")).string()));
  return done;
}

int export_run(ExportArguments options) {
  auto& wanted = options.wanted;
  wanted["--panel"] = !options.panel.empty();
  const std::vector<ExportKind> kinds = wanted_kinds(options);
  if (!options.times.empty() && !wanted["--openvt"] && !wanted["--png"])
    throw UsageError("--times: is for --openvt and --png; --panel takes its times itself: --panel \"0 h, 3 h\"");
  if (!options.pixel.empty() && !wanted["--ome-tiff"]) throw UsageError("--pixel: is for --ome-tiff");
  const bool only_tracks = std::ranges::all_of(
      kinds, [](const ExportKind& kind) { return kind.option == "--tracks" || kind.option == "--openvt"; });
  if (only_tracks && run::look_at(options.folder).has(run::Holds::a_study)) return export_study(options);
  const exchange::Times times = wanted_times(options.times);
  const DrawnKinds drawn{.movie = wanted["--movie"], .frames = wanted["--png"], .panel = wanted["--panel"]};
  const FinishedRun run = read_run(options.folder);
  require_drawable(run, options.drawn);
  if (wanted["--fields"] || wanted["--simularium"] || wanted["--ome-tiff"] || drawn.any()) {
    require_frames(run, options.folder);
    tell_lost_frames(run);
  }
  if (wanted["--simularium"]) require_even_frames(run, options.folder);
  if (drawn.panel) options.drawn.panel_times = panel_times(run, options.panel);
  if (drawn.frames) options.drawn.frames = frames_at(run, times);
  if (drawn.any()) require_drawing_tools(drawn);
  std::vector<exchange::RunTracks> tracks{single_run(run)};
  if (wanted["--openvt"]) tracks = at_times(std::move(tracks), times);
  const PythonKinds by_python{.ome_tiff = wanted["--ome-tiff"],
                              .simularium = wanted["--simularium"],
                              .pixel = pixel_of(options.pixel, run.film.head)};
  const std::string python = python_for(by_python);
  const std::string title = run_title(run.p, scenario_name(run.record, run.folder));
  const std::filesystem::path to = output_of(options);
  prepare(to, kinds, options.force);
  if (wanted["--fields"]) export_fields(run, to);
  if (wanted["--tracks"]) write_tracks(run, to);
  if (wanted["--openvt"]) write_openvt(tracks, openvt_model(run), to);
  export_by_python(run, by_python, python, title, to);
  export_drawn(run, drawn, options.drawn, to);
  print(fmt::format("exported to {}\n", to.string()));
  return done;
}

} // namespace

void add_export(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand(
      "export", "Write a run in other formats: tracks, fields, figures, a movie; of a study, its tracks");
  verb->footer(
      "Adds to what the folder holds: several kinds may be exported one after the other.\n"
      "fields.h5 with fields.xdmf opens in ParaView as it is.\n"
      "celltrackR: read.tracks.csv(\"tracks_celltrackr.csv\", sep = \",\", pos.columns = 3:4).\n"
      "Of a study, --tracks writes the tracks of all finished runs: tracks.csv as in the runs, tracks_spots.csv\n"
      "for CellTracksColab, TrackMate and celltrackR, and tracks_tracks.csv, a row per track, for CellTracksColab\n"
      "(docs/how-to/exchange.md).\n"
      "--simularium and --ome-tiff call Python with the package matrigrate, --ome-tiff with tifffile as well.\n"
      "--png, --panel and --movie call node and chromium, in which the player draws, and --movie calls ffmpeg. They\n"
      "have to be installed. Layers are degradation (f_degr: 0 fluid, 1 intact matrix), displacement, von_mises,\n"
      "pressure and fibre_von_mises, and those that the scenario gives the matrix, such as youngs_modulus.");
  const auto options = std::make_shared<ExportArguments>();
  verb->add_option("DIR", options->folder, "Folder of a run; for --tracks and --openvt also of a study")->required();
  for (const auto& [option, instead] : gone_kinds)
    verb->add_flag(std::string(option), options->wanted[std::string(option)])->group("");
  verb->add_flag("--fields", options->wanted["--fields"],
                 "fields.h5 and fields.xdmf for ParaView, also of a run that is not done yet");
  verb->add_flag("--tracks", options->wanted["--tracks"],
                 "The path for celltrackR (CSV) and TrackMate (CSV, XML); of a study, all paths in one CSV");
  verb->add_flag("--openvt", options->wanted["--openvt"],
                 "The positions of cells as OpenVT's table, with its records of simulation and simulator (JSON)");
  verb->add_option("--times", options->times,
                   "Of --openvt and --png: \"every 10 min\", or \"0 h, 1 h, 3 h\" (default: all times)");
  verb->add_flag("--simularium", options->wanted["--simularium"],
                 "run.simularium for the viewer at simularium.allencell.org: cells, adhesions and matrix over time");
  verb->add_flag("--ome-tiff", options->wanted["--ome-tiff"],
                 "fields.ome.tif for Fiji and napari: the fields of all frames as a stack with times and scale");
  verb->add_option("--pixel", options->pixel,
                   "Of --ome-tiff: width of a pixel (default: the spacing of the particles, 2 um)");
  verb->add_flag("--png", options->wanted["--png"], "A picture of each frame, as PNG and SVG: frame_0036.png");
  verb->add_option("--panel", options->panel,
                   "panel.svg for a publication: frames at these times side by side, \"0 h, 1 h, 3 h, 6 h\"");
  verb->add_flag("--movie", options->wanted["--movie"], "movie.mp4 of the player's view");
  verb->add_option("--fps", options->drawn.fps, "Of --movie: pictures a second (default: 30)")
      ->check(CLI::Range(1.0, 120.0));
  verb->add_option("--seconds", options->drawn.movie_seconds,
                   "Of --movie: how long it takes (default: a second for 15 min of the run)")
      ->check(CLI::Range(0.1, 3600.0));
  verb->add_option("--size", options->drawn.size,
                   "Of --movie and --png: width and height in pixels (default: 1280x720)");
  verb->add_flag("--follow", options->drawn.follow, "Of --movie: the view stays on the cell, as with --png");
  verb->add_flag("--whole", options->drawn.whole, "Of --png: the whole matrix, not the cell");
  verb->add_option("--layer", options->drawn.layer,
                   "What the matrix is coloured by (default: displacement; of --movie degradation)");
  verb->add_option("-o,--output", options->output, "Folder to write into (default: DIR/export)");
  verb->add_flag("--force", options->force, "Replace an earlier export of the same kind");
  verb->callback([options, &chosen] { chosen = [options] { return export_run(*options); }; });
}

} // namespace matrigrate::apps
