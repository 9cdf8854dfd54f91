#pragma once

#include "base/vector.hpp"
#include "state/state.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
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

} // namespace matrigrate
