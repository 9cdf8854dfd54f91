#pragma once

#include "base/vector.hpp"
#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// Where a cell is and what its protrusions do, from time to time. Read-only.
/// Test: tests/unit/observe/motion_test.cpp
namespace matrigrate {

/// The nucleus of a cell at one time.
struct NucleusRow {
  Vec2 centre = Vec2::Zero(); ///< centroid of the area inside the lamina [um]
  double area = 0.0;          ///< [um^2]
  double aspect = 1.0;        ///< aspect_ratio() [-]
};

/// A cell at one time.
struct TrackRow {
  double t = 0.0; ///< [s]
  std::uint64_t step = 0;
  std::uint32_t cell = 0;             ///< its id
  Vec2 centre = Vec2::Zero();         ///< centre of mass, centre_of_mass() [um]
  double area = 0.0;                  ///< [um^2]
  double perimeter = 0.0;             ///< [um]
  std::optional<double> polarization; ///< angle of d_pol [rad]; none before the first protrusion
  std::array<std::uint32_t, std::variant_size_v<Phase>> in_phase{}; ///< protrusions alive, in the order of the phases
  std::uint32_t initiated = 0;                                      ///< protrusions initiated so far
  std::optional<NucleusRow> nucleus{};                              ///< of a cell with one

  std::uint32_t alive() const; ///< protrusions of all phases
};

TrackRow track_row(const Cell& cell, const Instant& now);

/// Rows of all cells, in their order.
std::vector<TrackRow> track_rows(const State& s);

/// The rows of one cell.
std::vector<TrackRow> rows_of(std::span<const TrackRow> rows, std::uint32_t cell);

/// Number of a cell in files, counted from 1.
inline std::uint32_t number_of(std::uint32_t cell) { return cell + 1; }

/// Records of all protrusions of a cell, ended or alive, in the order of their initiation.
std::vector<ProtrusionRecord> protrusion_records(const Cell& cell);

// What several cells do together, from time to time. Test: tests/unit/observe/motion_test.cpp

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

/// Times at one interval, which some formats of other programs suppose. Test: tests/unit/observe/motion_test.cpp
namespace matrigrate::observe {

/// How far rising times are evenly spaced.
struct EvenTimes {
  double interval = 0.0;          ///< between the first two; 0 of fewer than two [s]
  std::size_t even = 0;           ///< how many from the first lie at multiples of the interval
  std::size_t all = 0;            ///< times
  double least = 0.0, most = 0.0; ///< interval between neighbours [s]

  bool is_even() const { return even == all; }
  /// The last one alone comes too soon, as where a run ends between two multiples.
  bool but_the_last() const { return even + 1 == all && least < interval; }
  /// "every 5 s", or "unevenly spaced, 5 to 10 s apart".
  std::string text() const;
};

/// Times agree within 1 ms.
EvenTimes even_times(std::span<const double> times);

/// The times of the rows, of all cells together, each once.
std::vector<double> times_of(std::span<const TrackRow> rows);

} // namespace matrigrate::observe
