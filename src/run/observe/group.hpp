#pragma once

#include "observe/tracks.hpp"
#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

/// What several cells do together, from time to time. Read-only. Test: tests/unit/observe/motion_test.cpp
namespace matrigrate {

/// Displacements of the cells are taken over this time, so that the to and fro of protrusions does not count as
/// motion [s].
inline constexpr double group_window = 600.0;

/// Several cells at one time; `undefined` where a value is not defined.
struct GroupRow {
  double t = 0.0; ///< [s]
  std::uint64_t step = 0;
  Vec2 centre = Vec2::Zero();   ///< mean of the centres of mass of the cells [um]
  double spread = undefined;    ///< root mean square distance of their centres of mass from it [um]
  double speed = undefined;     ///< mean |displacement| over the last group_window, over its time [um/h]
  double order = undefined;     ///< |mean of the unit vectors of these displacements|: 1 all the same way [-]
  double direction = undefined; ///< of that mean, from the x axis [rad]
  double nearest = undefined;   ///< mean distance of a centre of mass from that of the nearest other cell [um]
  double gap = undefined;       ///< least gap of two cortices that feel each other, negative where they overlap [um]
  std::size_t contacts = 0;     ///< pairs of cells that feel each other
};

/// @param earlier  rows of all cells at earlier times, in the order of time; rows of other cells are left out
GroupRow group_row(const State& s, std::span<const TrackRow> earlier, const Parameters& p);

} // namespace matrigrate
