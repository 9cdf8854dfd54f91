#pragma once

#include "simulation/workspace.hpp"

#include <functional>
#include <span>

/// The terms of the momentum balance, in the paper's order. Each law stands in the folder that its comment names.
/// dt is the step that is being taken [s].
namespace matrigrate {

/// Forces from outside the model, added to those of the particles [nN]: loads of a test.
using Loads = std::function<void(const State&, std::span<Vec2>)>;

/// Who meets whom in the matrix at x(t).
void update_neighbours(const State& s, Workspace& w);

/// Shape, protrusions and surroundings of the cell at x(t).
void describe_cell(const State& s, const Parameters& p, Workspace& w);

/// Eqs. (1) and (2), left side: viscous drag of all pairs of the matrix (ecm/viscosity), of the cell in the liquid, and
/// between both (contact/viscous). That of the matrix is taken a little behind (MODEL.md, D30).
void assemble_drag(const State& s, const Parameters& p, double dt, Workspace& w);

/// Eq. (2), right side: stress (ecm/stress or ecm/updated_lagrangian) and pressure of the fluid (ecm/fluid); Eq. (1),
/// right side: springs, bending, area, repulsion and actomyosin (cell), contact (contact/elastic), growth, pull of
/// maturation and adhesion (protrusion); loads. Stiff forces add what makes them linearly implicit to the drag.
void assemble_forces(const State& s, const Parameters& p, double dt, Workspace& w, const Loads& loads);

} // namespace matrigrate
