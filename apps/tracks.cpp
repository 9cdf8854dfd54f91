#include "apps/shipped_pages.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/track_options.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "report/run_page.hpp"
#include "run/folder_state.hpp"
#include "study_report/beside.hpp"
#include "tracks/read_tracks.hpp"
#include "tracks/readouts.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

struct TracksArguments {
  std::string file; ///< the only one, or the one that is read
  std::vector<std::string> files;
  std::string beside;
  TrackArguments reading;
  std::string every;
  std::string error;
  std::string output;
  std::size_t resamples = 200;
  bool drift = false;
  bool force = false;
  bool json = false;
  bool records = false;
};

Json columns_json(const tracks::ColumnNames& columns) {
  return {
      {"track", columns.track}, {"t", columns.t},         {"frame", columns.frame},     {"x", columns.x},
      {"y", columns.y},         {"group", columns.group}, {"made_up", columns.made_up}, {"measured", columns.measured}};
}

struct TrackReadouts {
  tracks::ReadoutValues value, standard_error;
};

Json readouts_json(const TrackReadouts& found) {
  Json json = Json::object();
  for (std::size_t r = 0; r < tracks::track_readouts.size(); ++r) {
    const auto& [name, unit, meaning] = tracks::track_readouts[r];
    json[std::string(name)] = {{"value", found.value[r]}, // null where it is not defined
                               {"standard_error", found.standard_error[r]},
                               {"unit", unit},
                               {"meaning", meaning}};
  }
  return json;
}

Json rows_json(const tracks::Tracks& cells) {
  Json rows = Json::array();
  for (const tracks::Track& track : cells.tracks)
    for (std::size_t i = 0; i < track.k.size(); ++i)
      rows.push_back(
          {track.name, track.start + static_cast<double>(track.k[i]) * cells.interval, track.x[i], track.y[i]});
  return rows;
}

Json to_json(const TracksArguments& asked, const tracks::Tracks& cells, const TrackReadouts& found) {
  Json json{{"file", asked.file},
            {"layout", cells.layout},
            {"encoding", cells.encoding},
            {"separator", std::string(cells.separator == '\0' ? 0 : 1, cells.separator)},
            {"decimal_comma", cells.decimal_comma},
            {"columns", columns_json(cells.columns)},
            {"um_per_unit", cells.scales.um_per_unit},
            {"times", cells.scales.by_frame ? "frame" : "t"},
            {"s_per_unit", cells.scales.s_per_unit},
            {"interval_s", cells.interval},
            {"tracks", cells.tracks.size()},
            {"positions", cells.positions()},
            {"missing", cells.missing()},
            {"notes", cells.notes},
            {"readouts", readouts_json(found)}};
  if (asked.output.empty())
    json["rows"] = rows_json(cells);
  else
    json["table"] = asked.output;
  return json;
}

std::string understood_text(const tracks::Tracks& cells) {
  const tracks::ColumnNames& columns = cells.columns;
  const bool by_frame = cells.scales.by_frame;
  return fmt::format(
      "{} tracks, {} positions, every {:g} s\nlayout {}: track {}, time {} x {:g} s, place {} and {} x {:g} um\n",
      cells.tracks.size(), cells.positions(), cells.interval, cells.layout, columns.track,
      by_frame ? columns.frame : columns.t, cells.scales.s_per_unit, columns.x, columns.y, cells.scales.um_per_unit);
}

std::string readouts_text(const TrackReadouts& found) {
  std::vector<std::vector<std::string>> rows{{"read-out", "value", "standard error"}};
  for (std::size_t r = 0; r < tracks::track_readouts.size(); ++r)
    rows.push_back({std::string(tracks::track_readouts[r].name), number_text(found.value[r]),
                    number_text(found.standard_error[r])});
  return aligned(rows, 1);
}

/// @param way  out of it, besides --force
/// @throws InputOutputError if the file that is to be written is there, or is one of those that are read
void check_output(const TracksArguments& asked, std::string_view way = {}) {
  std::error_code ignored;
  if (asked.output.empty() || !std::filesystem::exists(asked.output, ignored)) return;
  for (const std::string& file : asked.files)
    if (std::filesystem::equivalent(asked.output, file, ignored))
      throw InputOutputError(fmt::format("{}: is a file of tracks itself; name another one", asked.output));
  if (!asked.force) throw InputOutputError(fmt::format("{}: exists; --force replaces it{}", asked.output, way));
}

/// The tracks of the file as they are asked for.
tracks::Tracks wanted_tracks(const TracksArguments& asked) {
  const tracks::TrackOptions options = track_options(asked.reading, asked.records ? tracks::as_record : as_option);
  const double every = asked.every.empty() ? 0.0 : quantity_option(asked.every, "--every", "s");
  tracks::Tracks cells = tracks::read_tracks(asked.file, options);
  if (asked.drift) tracks::take_drift_away(cells, asked.file);
  return asked.every.empty() ? cells : tracks::at_interval(cells, every, asked.file);
}

double error_of(const TracksArguments& asked) {
  const double error = asked.error.empty() ? 0.0 : quantity_option(asked.error, "--error", "um");
  if (!(error >= 0.0)) throw UsageError(fmt::format("--error: {:g} um is no localisation error", error));
  return error;
}

/// "control" of data/control.csv; the whole of what was typed where two files, or a file and the model, have one name.
std::string label_of(const std::string& file, const std::vector<std::string>& files) {
  const auto stem = [](const std::string& one) { return std::filesystem::path(one).stem().string(); };
  return std::ranges::count(files, stem(file), stem) == 1 && stem(file) != "model" ? stem(file) : file;
}

/// The page of all files beside a run or a study.
int show_beside(TracksArguments asked) {
  const double error = error_of(asked);
  const run::FolderState state = run::look_at(asked.beside);
  run::require(state, run::Use::see_either);
  if (asked.output.empty()) asked.output = "beside.html";
  if (asked.json) throw UsageError("--json prints the read-outs of one file; --beside writes a page");
  check_output(asked, ", -o names another file");
  std::vector<study::CellGroup> groups;
  for (const std::string& file : asked.files) {
    asked.file = file;
    groups.push_back({.label = label_of(file, asked.files), .tracks = wanted_tracks(asked)});
  }
  study::require_comparable(groups);
  const study::Microscope microscope{
      .interval = groups.front().tracks.interval, .duration = study::usual_duration(groups), .error = error};
  for (study::CellGroup& group : groups) study::cut(group.tracks, microscope.duration);
  const std::vector<study::CellGroup> simulated = study::simulated_cells(asked.beside, microscope);
  groups.insert(groups.end(), simulated.begin(), simulated.end());
  Json page = study::beside_data(groups, microscope);
  for (const study::CellGroup& group : groups)
    for (const std::string& note : group.tracks.notes) {
      print(fmt::format("{}: {}\n", group.label, note));
      page["facts"].push_back({{"name", group.label}, {"value", note}});
    }
  write_file(asked.output, report::filled_page(study_page_template(), page));
  print(fmt::format("{}\nopen {}\n", page["summary"].get<std::string>(), asked.output));
  return done;
}

int read_and_tell(TracksArguments asked) {
  if (!asked.beside.empty()) return show_beside(std::move(asked));
  if (asked.files.size() > 1) throw UsageError("several files are for --beside: a run or a study to stand beside them");
  asked.file = asked.files.front();
  const double error = error_of(asked);
  check_output(asked);
  tracks::Tracks cells = wanted_tracks(asked);
  const tracks::TrackParts parts(cells);
  if (std::string buried = parts.buried(error); !buried.empty()) cells.notes.push_back(std::move(buried));
  TrackReadouts found{.value = parts.readouts(error), .standard_error = {}};
  found.standard_error = tracks::standard_errors(found.value, parts.drawn(error, asked.resamples));
  if (!asked.output.empty()) write_file(asked.output, tracks::plain_csv(cells));
  if (asked.json) {
    print_json(to_json(asked, cells, found));
    return done;
  }
  print(understood_text(cells));
  for (const std::string& note : cells.notes) print(note + "\n");
  print("\n" + readouts_text(found));
  if (!asked.output.empty()) print(fmt::format("\n{}: written\n", asked.output));
  return done;
}

} // namespace

void add_tracks(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("tracks", "Read measured tracks of cells, and print their read-outs");
  verb->footer(
      "Reads the spots of TrackMate (CSV, or its tracks as XML), and the tables of CellTracksColab, celltrackR, "
      "trackpy,\n"
      "btrack, napari, ImageJ's Manual Tracking, MTrackJ, MOSAIC, CellProfiler and Imaris; of other tables --columns\n"
      "names the columns. What is given counts, whatever the file states; a note then says so.\n"
      "--beside draws the cells of all files and of the model on one page, each figure of which can be saved as SVG.\n"
      "-o writes the plain form, track,t_s,x_um,y_um, which report --tracks and [[targets]] take as it is.\n"
      "The standard error is a bootstrap over tracks.\n"
      "--json prints {file, layout, encoding, separator, decimal_comma, columns, um_per_unit, times, s_per_unit,\n"
      "interval_s, tracks, positions, missing, notes, readouts: {NAME: {value, standard_error, unit, meaning}}}, and\n"
      "table (the file of -o) or rows [[track, t_s, x_um, y_um], ...].");
  const auto options = std::make_shared<TracksArguments>();
  verb->add_option("FILE", options->files, "File of tracks; with --beside several, of groups of cells")->required();
  verb->add_option(
      "--beside", options->beside,
      "Folder of a run or a study: writes a page (-o, default beside.html) with paths, mean square displacements and "
      "distributions of all files and of the model, at the interval, duration and --error of the files");
  add_track_options(*verb, options->reading);
  verb->add_option("--shortest", options->reading.options.shortest, "Leave tracks of fewer positions out (default 4)")
      ->check(CLI::Range(0, 100000));
  verb->add_option("--fewest", options->reading.options.fewest, "Refuse fewer tracks (default 2)")
      ->check(CLI::Range(0, 100000));
  verb->add_flag("--drift", options->drift, "Take the mean motion of all tracks away, where five go on together");
  verb->add_option("--every", options->every, "Take positions at a longer interval [s], a whole multiple");
  verb->add_option("--error", options->error,
                   "Localisation error of a coordinate [um], taken off the mean square displacement; with --beside "
                   "added to simulated coordinates");
  verb->add_option("--resamples", options->resamples, "Draws of the bootstrap (default 200)")
      ->check(CLI::Range(0, 100000));
  verb->add_option("-o,--output", options->output, "Write the tracks into this CSV file; with --beside the page")
      ->check([](const std::string& file) { return std::string(file.empty() ? "names no file" : ""); });
  verb->add_flag("--force", options->force, "Replace that file");
  verb->add_flag("--json", options->json, "Print JSON");
  verb->add_flag("--records", options->records, "Name options in notes and faults as {interval S}, for who words them");
  verb->callback([options, &chosen] { chosen = [options] { return read_and_tell(*options); }; });
}

} // namespace matrigrate::apps
