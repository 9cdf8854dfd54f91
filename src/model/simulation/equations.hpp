#pragma once

#include "simulation/workspace.hpp"

#include <functional>
#include <span>

/// The terms of the momentum balance, in the paper's order. Comments name the folder of each law. dt is the current
/// step [s].
namespace matrigrate {

/// Forces from outside the model, added to the forces of the particles [nN]: loads of verification cases, or of Python.
/// advance() calls them on the thread of its caller. Test: tests/physics/advance_test.cpp
using Loads = std::function<void(const State&, std::span<Vec2>)>;

/// Updates neighbours, shapes and surroundings at x(t), and makes A v = F of the two momentum balances, but for the
/// last part of F.
/// Eqs. (1) and (2), left side: viscous drag of all pairs of the matrix (ecm/loop/viscosity; evaluated with a lag,
/// MODEL.md, I30), of the cells in the liquid, and between cells and matrix (contact/viscous).
/// Eq. (2), right side: stress (ecm/loop/stress) and fibres (ecm/loop/fibres); Eq. (1), right side: springs, bending,
/// area, repulsion and actomyosin (cell), contact (contact/elastic), growth, pull of maturation and adhesion
/// (protrusion); nuclei (cell/nucleus, contact/nucleus); contact of cells (contact/cells). Stiff forces are linearly
/// implicit: they add dt times their stiffness to the drag.
void assemble(const State& s, const Parameters& p, double dt, Workspace& w);

/// Adds the rest of Eq. (2), right side: pressure of the fluid (ecm/loop/fluid), what the cells do to the matrix, and
/// loads; then F is whole. A is only read: a solver prepares itself beside.
void complete_forces(const State& s, const Parameters& p, Workspace& w, const Loads& loads);

} // namespace matrigrate
