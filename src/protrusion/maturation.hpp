#pragma once

#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/state.hpp"

#include <span>

/// Maturation by mechanosensing (Heck et al. 2020, section "Protrusion maturation"; MODEL.md, D19).
/// Test: tests/unit/protrusion/maturation_test.cpp
namespace matrigrate {

inline constexpr double maturation_step = 0.1; ///< f_mat gained in a step [-]
inline constexpr int most_maturation_steps = 10;

/// f_mat while maturing, after a number of steps done: 0.1 (steps + 1), at most 1 [-].
double maturing_f_mat(int steps);

/// Force of the adhesion at which the running step is done: (f_mat - 0.1) F_am + 0.98 x 0.1 F_am [nN].
double step_force(int steps, const Parameters& p);

/// f_mat at the end of maturation: 0.1 (steps done + the part of the running one that its force has reached), at least
/// that of the body, at most 1 [-].   @param F  force of the adhesion [nN]
double final_f_mat(int steps, double F, const Parameters& p);

/// Adds the pull F_mat = f_mat F_am on the centre of each maturing protrusion, against d_prot, and the high drag of
/// the three particles at either end of it that pins its base.
/// @param force  of all nodes [nN]
void add_maturation(const State& s, const Parameters& p, std::span<Vec2> force, DragSystem& A);

} // namespace matrigrate
