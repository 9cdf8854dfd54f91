#pragma once

#include "simulation/workspace.hpp"

#include <functional>
#include <span>

/// The terms of the momentum balance, in the paper's order. Each law stands in the folder that its comment names.
namespace matrigrate {

/// Forces from outside the model, added to those of the particles [nN]: loads of a test.
using Loads = std::function<void(const State&, std::span<Vec2>)>;

/// Eq. (2), left side: viscous drag of all pairs, ecm/viscosity.
void assemble_drag(const State& s, const Parameters& p, Workspace& w);

/// Eq. (2), right side: stress (ecm/stress or ecm/updated_lagrangian), pressure of the fluid (ecm/fluid), loads.
void assemble_forces(const State& s, const Parameters& p, Workspace& w, const Loads& loads);

} // namespace matrigrate
