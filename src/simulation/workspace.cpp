#include "simulation/workspace.hpp"

#include "solve/conjugate_gradient.hpp"

namespace matrigrate {

Workspace::Workspace(const State& s, const Parameters& p)
    : reference(s.ecm, p.ecm), neighbours(2.0 * p.ecm.smoothing_length, p.ecm.verlet_skin),
      solver(std::make_unique<ConjugateGradient>(p.solver.tolerance, p.solver.max_iterations)) {}

} // namespace matrigrate
