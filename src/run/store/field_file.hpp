#pragma once

#include "observe/frame.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace matrigrate::store {

// fields.h5 and fields.xdmf: the frames of a run for h5py, ParaView and others.
//
// Attributes of the file: program, version, seed, trajectory_hash, scenario. Arrays of numbers of 32 bits, each with
// an attribute `units`; one chunk per frame, compressed:
//   /time [s], one per frame
//   /matrix/reference, a position per particle; /matrix/position, displacement, velocity, f_degr, pressure, von_mises,
//   fibre_von_mises, solid: (frames, particles), vectors (frames, particles, 3) with z = 0
//   /matrix/obstacle, 1 for the particles of rigid obstacles, /matrix/youngs_modulus and other layers of
//   state/matrix_field.hpp: only where they are not the same everywhere; /matrix/attractant (frames, particles): only
//   where there is any /nucleus/position: (frames, particles of the nuclei), only of cells with nuclei
//   /outline/position, front, protrusion, phase, f_mat, curvature, actomyosin_force: (frames, particles of the cortex)
//   /outline/cell and /protrusions/cell, the number of the cell from 1: only where there are several
//   /frames/<k>/matrix/position and so on: the same numbers frame by frame, as views (virtual datasets) of the above
//   /protrusions/frame, id, centre, phase, anchor, f_mat, force: a row for each protrusion alive in a frame
//   /anchors/frame, id, position, f_mat, force: a row for each protrusion that adheres in a frame, and views of these
//   in /frames/<k>/anchors/ where there are any
// Test: tests/unit/store/field_file_test.cpp

inline constexpr const char* field_file_name = "fields.h5";
inline constexpr const char* field_index_name = "fields.xdmf";

/// What made the frames, a function of the run alone: no date, so that a resumed run writes the same bytes.
struct FieldOrigin {
  std::string program;
  std::string version;
  std::uint64_t seed = 0;
  std::string trajectory_hash;
  std::string scenario; ///< TOML, every parameter with its value and unit
};

/// The bytes of fields.h5.
/// @throws InputOutputError if HDF5 refuses
std::string field_file(const observe::Film& film, const FieldOrigin& origin = {});

/// Writes fields.h5 and fields.xdmf of a run's log into its folder; takes one frame at a time.
/// @param frames  that the log must hold
/// @throws InputOutputError naming the path and the reason, also if a frame is no longer whole
void write_field_files(const std::filesystem::path& folder, std::size_t frames, const FieldOrigin& origin = {});

/// Writes fields.h5 and fields.xdmf of a film into the folder.
/// @throws InputOutputError naming the path and the reason
void write_field_files(const std::filesystem::path& folder, const observe::Film& film, const FieldOrigin& origin = {});

/// fields.xdmf: for ParaView, which reads the arrays of fields.h5 beside it. Grids `matrix` (points), `outline` (a
/// closed line a cell) and `anchors` (points), at their times [s]; there are no anchors at times without an adhesion.
/// Names views, since not every reader of XDMF chooses a part of an array.
/// @param first    frame, which tells the sizes; none: no frames
/// @param times    of all frames [s]
/// @param anchors  how many adhesions each frame has
std::string field_index(const observe::Frame* first, std::span<const double> times,
                        std::span<const std::size_t> anchors);

/// Which frames are read of a file: all, or those that are whole.
enum class Wanted { all, whole };

/// The frames of a fields.h5.
/// @throws InputOutputError if it is none, or one of `all` frames cannot be read
observe::Film read_field_file(std::string_view bytes, Wanted wanted = Wanted::all);

/// The frames of the field file of a run's folder; none if it has none.
/// @throws InputOutputError naming the file, as read_field_file or if it cannot be read
observe::Film read_field_film(const std::filesystem::path& folder, Wanted wanted);

/// The frames that a run's folder holds: those of its log, else of its field file; none if it has neither.
/// @throws InputOutputError naming the file, if it cannot be read
/// @param each  may take away fields that are not wanted
observe::Film read_film(const std::filesystem::path& folder, const std::function<void(observe::Frame&)>& each = {});

} // namespace matrigrate::store
