// The read-outs of tracks in matrigrate._core. What users see is matrigrate.tracks (python/matrigrate/tracks.py).
#include "tracks.hpp"

#include "tracks/drift.hpp"
#include "tracks/readouts.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace matrigrate {
namespace {

/// Positions [um], one row an interval, NaN in gaps.
using Positions = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The positions that are there.
tracks::Track track_of(const Positions& positions) {
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

tracks::TrackParts parts_of(const std::vector<Positions>& positions, double interval) {
  tracks::Tracks all;
  all.interval = interval;
  for (const Positions& one : positions) {
    tracks::Track& track = all.tracks.emplace_back(track_of(one));
    if (const std::size_t first = track.k.empty() ? 0 : track.k.front(); first > 0)
      for (std::size_t& k : track.k) k -= first;
  }
  return tracks::TrackParts(all);
}

/// The drift [um], one row an interval from the first start [s] on, and what is said of it.
std::pair<py::array_t<double>, std::string> drift_of(const std::vector<Positions>& positions,
                                                     const std::vector<double>& starts, double interval) {
  tracks::Tracks all;
  all.interval = interval;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    all.tracks.push_back(track_of(positions[i]));
    all.tracks.back().start = starts.at(i);
  }
  const tracks::Drift drift = tracks::drift_of(all);
  py::array_t<double> rows({static_cast<py::ssize_t>(drift.x.size()), py::ssize_t{2}});
  auto at = rows.mutable_unchecked<2>();
  for (py::ssize_t k = 0; k < at.shape(0); ++k) {
    at(k, 0) = drift.x[static_cast<std::size_t>(k)];
    at(k, 1) = drift.y[static_cast<std::size_t>(k)];
  }
  return {rows, drift.said};
}

py::array_t<double> array_of(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

} // namespace

void add_tracks(py::module_& module) {
  std::vector<std::pair<std::string, std::string>> meanings;
  for (const tracks::ReadoutMeaning& readout : tracks::track_readouts)
    meanings.emplace_back(readout.name, readout.meaning);
  module.attr("track_readouts") = meanings;
  module.def("drift", &drift_of);
  module.def("standard_errors",
             [](const tracks::ReadoutValues& value, const std::vector<tracks::ReadoutValues>& drawn) {
               return tracks::standard_errors(value, drawn);
             });
  py::class_<tracks::TrackParts>(module, "TrackParts")
      .def(py::init(&parts_of))
      .def("readouts", [](const tracks::TrackParts& parts, double error) { return parts.readouts(error); })
      .def("drawn", &tracks::TrackParts::drawn)
      .def("buried", &tracks::TrackParts::buried)
      .def("msd", [](const tracks::TrackParts& parts) { return array_of(parts.msd()); });
}

} // namespace matrigrate
