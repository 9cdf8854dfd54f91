#pragma once

#include <pybind11/pybind11.h>

namespace matrigrate {

/// Adds the read-outs of tracks: TrackParts, and track_readouts, pairs of name and meaning.
void add_tracks(pybind11::module_& module);

} // namespace matrigrate
