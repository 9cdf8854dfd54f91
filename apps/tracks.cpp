#include "apps/terminal/terminal.hpp"
#include "apps/terminal/text_table.hpp"
#include "apps/track_options.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "tracks/drift.hpp"
#include "tracks/read_tracks.hpp"
#include "tracks/readouts.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

struct TracksArguments {
  std::string file;
  TrackArguments reading;
  std::string every;
  std::string error;
  std::string output;
  std::size_t resamples = 200;
  bool drift = false;
  bool force = false;
  bool json = false;
};

Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string text_of_separator(char separator) { return separator == '\0' ? std::string() : std::string(1, separator); }

Json columns_json(const tracks::ColumnsUsed& columns) {
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
    json[std::string(name)] = {{"value", number_json(found.value[r])},
                               {"standard_error", number_json(found.standard_error[r])},
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
            {"separator", text_of_separator(cells.separator)},
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
  const tracks::ColumnsUsed& columns = cells.columns;
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

/// @throws InputOutputError if the file that is to be written is there, or is the one that is read
void check_output(const TracksArguments& asked) {
  std::error_code ignored;
  if (asked.output.empty() || !std::filesystem::exists(asked.output, ignored)) return;
  if (std::filesystem::equivalent(asked.output, asked.file, ignored))
    throw InputOutputError(fmt::format("{}: is the file of tracks itself; name another one", asked.output));
  if (!asked.force) throw InputOutputError(fmt::format("{}: exists; --force replaces it", asked.output));
}

/// The tracks of the file as they are asked for.
tracks::Tracks wanted_tracks(const TracksArguments& asked) {
  const tracks::TrackOptions options = track_options(asked.reading);
  const double every = asked.every.empty() ? 0.0 : quantity_option(asked.every, "--every", "s");
  tracks::Tracks cells = tracks::read_tracks(asked.file, options);
  if (asked.drift) try {
      tracks::take_drift_away(cells);
    } catch (const std::invalid_argument& fault) {
      throw ConfigurationError({{asked.file, 0, 0, {}, fault.what()}});
    }
  return asked.every.empty() ? cells : tracks::at_interval(cells, every, asked.file);
}

int read_and_tell(const TracksArguments& asked) {
  const double error = asked.error.empty() ? 0.0 : quantity_option(asked.error, "--error", "um");
  if (!(error >= 0.0)) throw UsageError(fmt::format("--error: {:g} um is no localisation error", error));
  check_output(asked);
  tracks::Tracks cells = wanted_tracks(asked);
  const tracks::TrackParts parts(cells);
  if (const double square = parts.buried(error); square > 0.0)
    cells.notes.push_back(
        fmt::format("MSD at one interval, {:.3g} um2, is below 4 error^2 = {:.3g} um2: the error is larger than the "
                    "cells move, so slopes and the persistence time are not defined",
                    square, 4.0 * error * error));
  TrackReadouts found{.value = parts.readouts(error), .standard_error = {}};
  found.standard_error = tracks::standard_errors(found.value, parts.drawn(error, asked.resamples));
  if (!asked.output.empty()) write_file(asked.output, tracks::plain_csv(cells));
  if (asked.json) {
    print(to_json(asked, cells, found).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
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
      "names the columns. What is given counts, whatever the file states; a note then "
      "says so.\n"
      "-o writes the plain form, track,t_s,x_um,y_um, which report --tracks and [[targets]] take as it is.\n"
      "The standard error is a bootstrap over tracks.\n"
      "--json prints {file, layout, encoding, separator, decimal_comma, columns, um_per_unit, times, s_per_unit,\n"
      "interval_s, tracks, positions, missing, notes, readouts: {NAME: {value, standard_error, unit, meaning}}}, and\n"
      "table (the file of -o) or rows [[track, t_s, x_um, y_um], ...].");
  const auto options = std::make_shared<TracksArguments>();
  verb->add_option("FILE", options->file, "File of tracks")->required();
  add_track_options(*verb, options->reading);
  verb->add_option("--shortest", options->reading.options.shortest, "Leave tracks of fewer positions out (default 4)");
  verb->add_option("--fewest", options->reading.options.fewest, "Refuse fewer tracks (default 2)");
  verb->add_flag("--drift", options->drift, "Take the mean motion of all tracks away, where five go on together");
  verb->add_option("--every", options->every, "Take positions at a longer interval [s], a whole multiple");
  verb->add_option("--error", options->error,
                   "Localisation error of a coordinate [um], taken off the mean square displacement");
  verb->add_option("--resamples", options->resamples, "Draws of the bootstrap (default 200)")
      ->check(CLI::Range(0, 100000));
  verb->add_option("-o,--output", options->output, "Write the tracks into this CSV file")
      ->check([](const std::string& file) { return std::string(file.empty() ? "names no file" : ""); });
  verb->add_flag("--force", options->force, "Replace that file");
  verb->add_flag("--json", options->json, "Print JSON");
  verb->callback([options, &chosen] { chosen = [options] { return read_and_tell(*options); }; });
}

} // namespace matrigrate::apps
