#pragma once

#include "contact/cells.hpp"
#include "contact/proximity.hpp"
#include "cues/diffusion.hpp"
#include "ecm/drag_cache.hpp"
#include "ecm/loop/fibres.hpp"
#include "ecm/loop/stress.hpp"
#include "ecm/reference.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/parameters.hpp"
#include "protrusion/membership.hpp"
#include "simulation/step_limits.hpp"
#include "solve/drag_system.hpp"
#include "sph/interpolate.hpp"
#include "sph/neighbours.hpp"
#include "state/state.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace matrigrate {

/// Diagnostics of the last step, and counts since the start. Never read by the physics.
struct StepHealth {
  SolveReport solve;
  std::size_t density_bounds = 0; ///< particles at a density bound after the last step
  std::size_t orphans = 0;        ///< particles fluidized because of lost support since the start
  std::size_t torn = 0;           ///< particles fluidized at a density bound since the start
  std::size_t engulfed = 0;       ///< solid particles fluidized inside a cell since the start
  std::size_t list_builds = 0;    ///< updates of the neighbour list since the start, local or global
};

/// Quantities of a cell at x(t) derived from State: shape, protrusions, nearby particles.
struct CellShape {
  Membership membership;
  std::vector<Vec2> normals;                ///< outward unit normals of the cortex particles
  std::vector<NearbyParticle> nearby;       ///< solid particles within the support of the kernel
  std::vector<PointWeights> anchor_weights; ///< parallel to Cell::protrusions
  std::vector<LawPlace> places;             ///< of each particle of the cortex, if a law uses them
};

/// Everything that is derived from State and Parameters and can be rebuilt at any time.
struct Workspace {
  /// For steps of at most run.time_step.
  Workspace(const State& s, const Parameters& p);

  std::vector<Laws> laws; ///< all alike: one thread at a time evaluates formulas of each
  std::unique_ptr<DragSolver> solver;
  Reference reference;
  FibreNetwork fibres;
  VerletList neighbours;
  DragCache drag_cache;               ///< of the matrix
  std::optional<Diffusion> diffusion; ///< of the attractant, where it diffuses
  std::vector<CellShape> cells;       ///< parallel to State::cells
  std::vector<CellTouch> touches;     ///< of cells with each other, at x(t)
  /// Given from outside, as loads are: for each cell, a factor on the rate at which each particle of its cortex
  /// initiates protrusions, >= 0 [-]; an empty one is 1 for all. Test: tests/physics/migration_test.cpp
  std::vector<std::vector<double>> propensity;
  DragSystem drag;
  std::vector<Vec2> force;            ///< all forces except drag, on all nodes including clamped ones [nN]
  NodeForces on_matrix;               ///< of them, those of the cells on the matrix
  Vec2 outer_force = Vec2::Zero();    ///< the part of the external forces: growth, maturation, loads [nN]
  std::vector<Vec2> v;                ///< velocities of all nodes [um/s]
  std::vector<Vec2> v_now;            ///< those of the state at the begin of the step [um/s]
  StepLimits limits;                  ///< of the explicit step
  double theta = 0.0;                 ///< relaxation_theta() of this step [-]
  SolidFields solid;                  ///< of the elastic forces
  std::vector<double> fluid_pressure; ///< [kPa]
  StepHealth health;
  std::size_t without_bias = 0; ///< cells whose bias of initiation was 0 along the whole cortex in the last step
};

} // namespace matrigrate
