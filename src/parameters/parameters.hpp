#pragma once

#include <cstdint>

/// Every parameter of a simulation, in internal units: um, s, nN; stress in kPa, viscosity in nN s/um^2 = 1000 Pa s.
/// Defaults are Table 1 of Heck et al. 2020 and the interpretations of MODEL.md. Names, units, ranges, symbols and
/// sources stand once, in schema.cpp; nothing else in the program lists the parameters.
namespace matrigrate {

/// Arrangement of the matrix particles at the start.
enum class Lattice { square, hexagonal };

/// Where the sums of the solid stress are taken: over reference neighbours, or over current ones.
enum class Formulation { total_lagrangian, updated_lagrangian };

struct RunParameters {
  double duration = 6.0 * 3600.0; ///< [s]
  double time_step = 0.4;         ///< [s]
  std::uint64_t seed = 1;
  int threads = 1; ///< 0: as many as the machine has; never changes a result
};

struct EcmParameters {
  double radius = 150.0;         ///< radius of the disc [um]
  double particle_spacing = 2.0; ///< dp [um]
  double smoothing_length = 2.6; ///< h [um]; the kernel's support is 2h
  Lattice lattice = Lattice::square;
  double thickness = 1.0;       ///< t_z [um]
  double youngs_modulus = 0.2;  ///< E [kPa]
  double poissons_ratio = 0.45; ///< nu [-]
  double viscosity = 1.0;       ///< mu [nN s/um^2]
  bool cell_hole = true;        ///< the cell's disc and margin start as fluid
  Formulation formulation = Formulation::total_lagrangian;
  double hourglass_weight = 0.5; ///< a_hg [-]
  double support_floor = 0.3;    ///< smallest eigenvalue of the support tensor that is inverted as it is [-]
  double orphan_support = 0.2;   ///< a solid particle with less of its intact support becomes fluid [-]
  double density_min = 0.6;      ///< lower bound of rho/rho_0 [-]
  double density_max = 1.8;      ///< upper bound of rho/rho_0 [-]
  double verlet_skin = 1.0;      ///< neighbours are listed up to 2h + skin [um]
};

struct CellParameters {
  double radius = 15.0; ///< R [um]
};

struct DegradationParameters {
  double body_distance = 1.9; ///< reach of degradation around the cell's body [um]
};

struct SolverParameters {
  double tolerance = 1e-6; ///< relative residual at which the drag system counts as solved [-]
  int max_iterations = 5000;
};

struct Parameters {
  RunParameters run;
  EcmParameters ecm;
  CellParameters cell;
  DegradationParameters degradation;
  SolverParameters solver;
};

} // namespace matrigrate
