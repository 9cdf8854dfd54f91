// Tracks and their read-outs in matrigrate._core. What users see is matrigrate.tracks
// (python/matrigrate/tracks/__init__.py).
#include "base/failure.hpp"
#include "tracks/read_tracks.hpp"
#include "tracks/readouts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace matrigrate {
namespace {

/// Positions [um], one row an interval, NaN in gaps.
using Positions = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The positions that are there.
tracks::Track track_of(const Positions& positions) {
  if (positions.ndim() != 2 || positions.shape(1) != 2) throw py::value_error("positions must have the shape (n, 2)");
  const auto at = positions.unchecked<2>();
  tracks::Track track;
  for (py::ssize_t k = 0; k < at.shape(0); ++k) {
    if (!std::isfinite(at(k, 0)) || !std::isfinite(at(k, 1))) continue;
    track.k.push_back(static_cast<std::size_t>(k));
    track.x.push_back(at(k, 0));
    track.y.push_back(at(k, 1));
  }
  return track;
}

tracks::Tracks tracks_of(const std::vector<Positions>& positions, const std::vector<double>& starts, double interval) {
  tracks::Tracks all;
  all.interval = interval;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    all.tracks.push_back(track_of(positions[i]));
    all.tracks.back().start = starts.at(i);
  }
  return all;
}

/// With the first position of each at 0 intervals.
tracks::TrackParts parts_of(const std::vector<Positions>& positions, double interval) {
  tracks::Tracks all = tracks_of(positions, std::vector<double>(positions.size()), interval);
  for (tracks::Track& track : all.tracks)
    if (const std::size_t first = track.k.empty() ? 0 : track.k.front(); first > 0)
      for (std::size_t& k : track.k) k -= first;
  return tracks::TrackParts(all);
}

/// Positions up to the last one of each track.
std::vector<Positions> positions_of(const tracks::Tracks& all) {
  std::vector<Positions> list;
  for (const tracks::Track& track : all.tracks) {
    Positions& rows = list.emplace_back(
        std::vector<py::ssize_t>{track.k.empty() ? 0 : static_cast<py::ssize_t>(track.span()) + 1, 2});
    std::fill_n(rows.mutable_data(), rows.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < track.k.size(); ++i) {
      const auto k = static_cast<py::ssize_t>(track.k[i]);
      rows.mutable_at(k, 0) = track.x[i];
      rows.mutable_at(k, 1) = track.y[i];
    }
  }
  return list;
}

/// x and y of the drift [um] at each interval from the first start [s] on.
std::pair<std::vector<double>, std::vector<double>> drift_of(const std::vector<Positions>& positions,
                                                             const std::vector<double>& starts, double interval) {
  tracks::Drift drift = tracks::drift_of(tracks_of(positions, starts, interval));
  return {std::move(drift.x), std::move(drift.y)};
}

std::pair<std::vector<Positions>, std::string> without_drift(const std::vector<Positions>& positions,
                                                             const std::vector<double>& starts, double interval) {
  tracks::Tracks all = tracks_of(positions, starts, interval);
  tracks::take_drift_away(all);
  return {positions_of(all), all.notes.back()};
}

std::vector<Positions> at_interval(const std::vector<Positions>& positions, double interval, double wanted) {
  return positions_of(
      tracks::at_interval(tracks_of(positions, std::vector<double>(positions.size()), interval), wanted, {}));
}

/// An option as an argument of tracks.read(): frame_interval=S, columns={"track": "NAME", "t": 2}, drift=True.
std::string as_argument(std::string_view option, std::string_view value) {
  std::string name(option == "interval" ? "frame_interval" : option);
  std::ranges::replace(name, '-', '_');
  if (value.empty()) return name;
  if (value == "true") return name + "=True";
  if (name == "time_unit" || name == "splits" || name == "layout") return fmt::format("{}=\"{}\"", name, value);
  if (name != "columns") return fmt::format("{}={}", name, value);
  std::vector<std::string> pairs;
  for (const auto& [key, column] : tracks::column_pairs(value)) {
    const bool number = column.find_first_not_of("0123456789") == std::string::npos;
    pairs.push_back(fmt::format("\"{}\": {}", key, number ? column : '"' + column + '"'));
  }
  return fmt::format("columns={{{}}}", fmt::join(pairs, ", "));
}

/// @throws ConfigurationError with all that is wrong with them
tracks::TrackOptions options_of(const py::dict& given) {
  tracks::TrackOptions options;
  options.wording = as_argument;
  std::vector<Fault> faults;
  const auto take = [&given]<class T>(const char* name, T& place) {
    if (given.contains(name)) place = given[name].cast<T>();
  };
  take("pixel", options.pixel);
  take("interval", options.interval);
  take("time_unit", options.time_unit);
  take("layout", options.layout);
  take("jitter", options.jitter);
  take("shortest", options.shortest);
  take("fewest", options.fewest);
  std::vector<std::string> columns;
  std::string splits = "refuse";
  take("columns", columns);
  take("splits", splits);
  for (std::string& fault : tracks::set_words(options, columns, splits))
    faults.push_back({{}, 0, 0, {}, std::move(fault)});
  if (!faults.empty()) throw ConfigurationError(std::move(faults));
  return options;
}

/// Interval [s], notes, names, starts [s] and positions of the tracks of a file.
/// @param text  of the table, where there is no file; then `file` stands for it in messages
py::tuple read_tracks(const std::string& file, const std::optional<std::string>& text, const py::dict& given) {
  const tracks::TrackOptions options = options_of(given);
  const bool drift = given.contains("drift") && given["drift"].cast<bool>();
  tracks::Tracks all;
  {
    const py::gil_scoped_release others; // may use Python meanwhile
    all = text ? tracks::parse_tracks(*text, file, options) : tracks::read_tracks(file, options);
    if (drift) tracks::take_drift_away(all, file);
  }
  std::vector<std::string> names;
  std::vector<double> starts;
  for (const tracks::Track& track : all.tracks) {
    names.push_back(track.name);
    starts.push_back(track.start);
  }
  return py::make_tuple(all.interval, all.notes, names, starts, positions_of(all));
}

} // namespace

void add_tracks(py::module_& module) {
  std::vector<std::pair<std::string, std::string>> meanings;
  for (const tracks::ReadoutMeaning& readout : tracks::track_readouts)
    meanings.emplace_back(readout.name, readout.meaning);
  module.attr("track_readouts") = meanings;
  module.def("read_tracks", &read_tracks);
  module.def("at_interval", &at_interval);
  module.def("drift", &drift_of);
  module.def("without_drift", &without_drift);
  module.def("standard_errors",
             [](const tracks::ReadoutValues& value, const std::vector<tracks::ReadoutValues>& drawn) {
               return tracks::standard_errors(value, drawn);
             });
  py::class_<tracks::TrackParts>(module, "TrackParts")
      .def(py::init(&parts_of))
      .def("readouts", [](const tracks::TrackParts& parts, double error) { return parts.readouts(error); })
      .def("drawn", &tracks::TrackParts::drawn)
      .def("buried", &tracks::TrackParts::buried)
      .def("msd", [](const tracks::TrackParts& parts) { return parts.msd(); });
}

} // namespace matrigrate
