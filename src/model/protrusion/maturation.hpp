#pragma once

#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cell.hpp"

#include <cstdint>
#include <span>

/// Maturation by mechanosensing (Heck et al. 2020, section "Protrusion maturation"; MODEL.md, I19).
/// Test: tests/unit/protrusion/maturation_test.cpp
namespace matrigrate {

inline constexpr double maturation_step = 0.1; ///< f_mat gained in a step [-]
inline constexpr int max_maturation_steps = 10;

/// F_am of the pull of maturation: that of as many strands as maturation_strands says (MODEL.md, I28) [nN].
double maturation_force(const Parameters& p);

/// Longest duration of maturation: T_mat, a time step for each of its steps, whose wait does not count, and two more
/// [s].
double longest_maturation(const Parameters& p);

/// f_mat while maturing, after a number of steps done: 0.1 (steps + 1), at most 1 [-].
double maturing_f_mat(int steps);

/// Force of the adhesion at which the running step is done: (f_mat - 0.1) F_am + step_threshold x 0.1 F_am, with the
/// F_am of maturation_force() [nN].
double step_force(int steps, const Parameters& p);

/// Whether the running step is done: the adhesion bears its force, and, if it is the first one, the recoil of growth is
/// over. While the matrix springs back, it carries the tip along, so that the adhesion bears F_mat although nothing
/// resists (MODEL.md, I19).
/// @param F  force of the adhesion [nN]   @param recoil  speed of the tip towards its base [um/s]
bool step_done(int steps, double F, double recoil, const Parameters& p);

/// How long ago the running step, which is done, was done: since the force passed step_force() within the step of dt.
/// Or, if it is the first one and the force has been there for longer, since the recoil was over: it is known as the
/// mean speed of a step, so that is dt on average [s].
/// @param loading  rate of F in the step [nN/s]
double time_since_done(int steps, double F, double loading, const Parameters& p, double dt);

/// f_mat at the end of maturation: 0.1 (steps done + the part of the running one), at least that of the body, at most 1
/// [-]. The part of the running step is the time since the last one over the mean time of those done, at most 1, so
/// that this is the paper's 0.1 T_mat over the mean time of a step where steps come evenly; without a step, the part of
/// its force that is reached.
/// @param last_step  when the last step was done [s]   @param F  force of the adhesion [nN]
double final_f_mat(int steps, double last_step, double F, const Parameters& p);

/// Adds the pull F_mat = f_mat F_am on the centre of each maturing protrusion, against d_prot, and the high drag of
/// pinned_particles at either end of it that pins its base; also the pull that is left of F_mat in contracting
/// protrusions, between the centre and both ends of the base.
/// @param first  node of particle 0 of the cortex   @param force  of all nodes [nN]
void add_maturation(const Cell& cell, const Parameters& p, double dt, std::uint32_t first, std::span<Vec2> force,
                    DragSystem& A);

/// An adhesion when its protrusion begins to contract (Heck et al. 2020, section "Maturation"; MODEL.md, I20): the
/// bundle takes over handover_share of f_mat F_am.
Contracting handover(const Maturing& maturing, double f_mat, double F, const Parameters& p);

/// The same after dt with a load F. What the last step of maturation loaded beyond f_mat F_am falls off first;
/// from then on the bundle gives way by what F exceeds that share, with the time constant handover_time (MODEL.md,
/// I20).
/// @param F  force of the adhesion [nN]
Contracting handed_over(Contracting phase, double F, const Parameters& p, double dt);

} // namespace matrigrate
