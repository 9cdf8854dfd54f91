// The read-outs of tracks in matrigrate._core. What users see is matrigrate.tracks (python/matrigrate/tracks.py).
#include "tracks.hpp"

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

/// The positions that are there, from the first one on.
tracks::Track track_of(const Positions& positions) {
  const auto at = positions.unchecked<2>();
  tracks::Track track;
  py::ssize_t first = -1;
  for (py::ssize_t k = 0; k < at.shape(0); ++k) {
    if (!std::isfinite(at(k, 0)) || !std::isfinite(at(k, 1))) continue;
    if (first < 0) first = k;
    track.k.push_back(static_cast<std::size_t>(k - first));
    track.x.push_back(at(k, 0));
    track.y.push_back(at(k, 1));
  }
  return track;
}

tracks::TrackParts parts_of(const std::vector<Positions>& positions, double interval) {
  tracks::Tracks all;
  all.interval = interval;
  for (const Positions& one : positions) all.tracks.push_back(track_of(one));
  return tracks::TrackParts(all);
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
  py::class_<tracks::TrackParts>(module, "TrackParts")
      .def(py::init(&parts_of))
      .def("readouts", [](const tracks::TrackParts& parts, double error) { return parts.readouts(error); })
      .def("drawn", &tracks::TrackParts::drawn)
      .def("buried", &tracks::TrackParts::buried)
      .def("msd", [](const tracks::TrackParts& parts) { return array_of(parts.msd()); });
}

} // namespace matrigrate
