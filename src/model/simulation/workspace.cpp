#include "simulation/workspace.hpp"

#include "base/parallel.hpp"
#include "ecm/loop/viscosity.hpp"
#include "solve/conjugate_gradient.hpp"
#include "solve/multigrid.hpp"

#include <algorithm>
#include <utility>

namespace matrigrate {

namespace {

/// The matrix where it was before anything moved.
EcmState at_reference(EcmState ecm) {
  ecm.x = ecm.X;
  return ecm;
}

std::unique_ptr<DragSolver> make_solver(const State& s, const Parameters& p) {
  if (p.solver.method == SolverMethod::conjugate_gradient || s.ecm.period_x > 0.0)
    return std::make_unique<ConjugateGradient>(solver_tolerance(p), p.solver.max_iterations);
  const EcmState ecm = at_reference(s.ecm);
  const Adjacency pairs = neighbours_within(ecm.x, 2.0 * p.ecm.smoothing_length, ecm.period_x);
  DragSystem reference;
  assemble_viscosity(ecm, p.ecm, RowPattern(pairs, ecm.clamped), reference);
  reference.position = ecm.x;
  return std::make_unique<Multigrid>(reference, p.ecm.particle_spacing, solver_tolerance(p), p.solver.max_iterations);
}

/// The reference; the solver is made beside it.
Reference make_reference(const State& s, const Parameters& p, std::unique_ptr<DragSolver>& solver) {
  std::optional<Reference> reference;
  side_by_side({[&] { solver = make_solver(s, p); }, [&] { reference.emplace(s.ecm, p.ecm); }});
  return *std::move(reference);
}

FibreNetwork make_fibres(const EcmState& ecm, const Parameters& p, const Reference& reference) {
  if (p.fibres.arrangement == FibreArrangement::none) return {};
  return {ecm, p.ecm, p.fibres, reference, fibre_table(p)};
}

/// For as many cells as may be advanced side by side.
std::vector<Laws> make_laws(const State& s, const Parameters& p) {
  constexpr std::size_t most = 16;
  std::vector<Laws> laws;
  do laws.emplace_back(p);
  while (laws.size() < std::min(most, s.cells.size()));
  return laws;
}

std::optional<Diffusion> make_diffusion(const EcmState& ecm, const Parameters& p) {
  if (ecm.attractant.empty() || p.cues.diffusion <= 0.0) return {};
  return Diffusion(ecm, p.ecm);
}

} // namespace

Workspace::Workspace(const State& s, const Parameters& p)
    : laws(make_laws(s, p)), reference(make_reference(s, p, solver)), fibres(make_fibres(s.ecm, p, reference)),
      neighbours(2.0 * (p.ecm.smoothing_length + drag_lag(p, p.run.time_step)), p.ecm.verlet_skin),
      drag_cache(s.ecm, p.ecm), diffusion(make_diffusion(s.ecm, p)), limits(step_limits(p, s.ecm)) {}

} // namespace matrigrate
