#pragma once

#include "ecm/loop/fibres.hpp"
#include "parameters/parameters.hpp"
#include "simulation/workspace.hpp"
#include "state/ecm.hpp"
#include "state/matrix_field.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace matrigrate::observe {

// What is kept of a state to be looked at: fields of the matrix, outlines of the cells, living protrusions. Numbers
// are stored as float32, rounded to their meaningful precision: 1/16384 um for displacements, four digits for
// velocities and stresses. Test: tests/unit/observe/frame_test.cpp

/// Numbers beside each other, those of an entry together: x0, y0, x1, y1, ...
using Floats = std::vector<float>;
using Bytes = std::vector<std::uint8_t>;

inline constexpr std::uint8_t of_none = 255; ///< outline particles without a protrusion

/// Fields of the matrix, one entry a particle.
struct MatrixFrame {
  Floats displacement;    ///< [um]
  Floats velocity;        ///< [um/s]
  Floats f_degr;          ///< 1 intact solid, 0 fluid [-]
  Floats pressure;        ///< of the solid, or of the fluid, compression positive [Pa]
  Floats von_mises;       ///< of the solid; 0 in the fluid [Pa]
  Floats fibre_von_mises; ///< Eq. (11); 0 in the fluid; empty without fibres [Pa]
  Floats attractant{};    ///< concentration; empty without attractant [-]
};

/// Particles of the cortex, around each cell, those of one cell after those of the other.
struct OutlineFrame {
  Floats x;         ///< [um]
  Floats f_mat;     ///< maturation of the cortex [-]
  Floats curvature; ///< convex positive [1/um]
  Floats force;     ///< magnitude of the actomyosin force on the particle [nN]
  Bytes front;      ///< 1 in the front of its cell; all of it before the first protrusion
  Bytes protrusion; ///< which of the frame's protrusions it belongs to, or of_none
  Bytes phase;      ///< of that protrusion, or of_none
  Floats cell{};    ///< number of its cell, counted from 1; empty where there is a single one
};

/// Where the particles of each cell end: the index behind its last one. One entry a cell.
std::vector<std::size_t> outline_ends(const OutlineFrame& outline);

/// Protrusions alive, of one cell after those of the other, in the order of initiation.
struct ProtrusionFrame {
  Floats id;     ///< as in protrusions.csv
  Floats centre; ///< index of the central particle on its cell
  Bytes phase;   ///< 0 growing, 1 maturing, 2 contracting, 3 finishing
  Floats anchor; ///< adhered point; NaN without one [um]
  Floats f_mat;  ///< maturation; 0 while growing [-]
  Floats force;  ///< of the adhesion; 0 without one [nN]
  Floats cell{}; ///< number of its cell, counted from 1; empty where there is a single one
};

struct Frame {
  double t = 0.0; ///< [s]
  MatrixFrame matrix;
  OutlineFrame outline;
  ProtrusionFrame protrusions;
  Floats nucleus{}; ///< particles of the nuclei, as many of each cell, in the order of cells; empty without nuclei [um]
};

/// Properties of the matrix that are kept with frames: those with a layer (state/matrix_field.hpp).
const std::vector<MatrixField>& matrix_layers();

/// What is the same in all frames.
struct FrameHead {
  double radius = 0.0;  ///< of the disc [um]
  double spacing = 0.0; ///< of the matrix particles [um]
  Floats reference;     ///< reference positions of the matrix particles [um]
  Bytes obstacle{};     ///< 1: particle of a rigid obstacle; empty where there is none
  /// Parallel to matrix_layers(); empty where the property is the same everywhere.
  std::vector<Floats> layers = std::vector<Floats>(matrix_layers().size());

  std::size_t particles() const { return reference.size() / 2; }
  bool operator==(const FrameHead&) const = default;
  /// True if obstacle and layers are empty or have one entry a particle.
  bool consistent() const;
};

/// All that was kept of a run.
struct Film {
  FrameHead head;
  std::vector<Frame> frames;
};
std::vector<double> times_of(const Film& film);

/// Where a field stands in files: the one table for all writers and readers of frames.
template <class Numbers>
struct FrameField {
  std::string_view name;    ///< in files: "matrix/displacement"
  std::string_view unit;    ///< "1" for a ratio or a count
  std::uint32_t components; ///< 1, or 2 for vectors
  Numbers& (*of)(Frame&);
  bool whole = false; ///< its numbers are whole, and not negative
  bool of_all = true; ///< else of frames of several cells, with attractant or with nuclei only

  bool of_protrusions() const { return name.starts_with("protrusions/"); }
  bool of_several_cells() const { return name.ends_with("/cell"); }
  const Numbers& in(const Frame& frame) const { return of(const_cast<Frame&>(frame)); } // of() only finds it
};
std::span<const FrameField<Floats>> float_fields();
std::span<const FrameField<Bytes>> byte_fields();

FrameHead frame_head(const State& s, const Parameters& p);

/// @param w  used for its fibres; all else comes from the state, so that a resumed run writes the same frames
Frame frame(const State& s, const Parameters& p, const Workspace& w);

} // namespace matrigrate::observe

namespace matrigrate {

/// Von Mises stress of the fibres, Heck et al. 2020, Eq. (11), one value a particle; NaN in the fluid [kPa].
/// Test: tests/unit/observe/frame_test.cpp
std::vector<double> fibre_stress_field(const EcmState& ecm, const FibreParameters& p, const FibreNetwork& network);

} // namespace matrigrate
