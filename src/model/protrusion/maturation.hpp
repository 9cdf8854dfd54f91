#pragma once

#include "parameters/laws/law.hpp"
#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cell.hpp"

#include <cstdint>
#include <span>

/// Maturation by mechanosensing (Heck et al. 2020, section "Protrusion maturation"; MODEL.md, I19).
/// Test: tests/unit/protrusion/maturation_test.cpp
namespace matrigrate {

inline constexpr int max_maturation_steps = 10;

/// F_am of the pull of maturation: that of as many strands as maturation_strands says (MODEL.md, I28) [nN].
double maturation_force(const Parameters& p);

/// Longest duration of maturation: T_mat, a time step for each of its steps, whose wait does not count, and two more
/// [s].
double longest_maturation(const Parameters& p);

/// f_mat while maturing, after a number of steps done: by laws.maturation of them and the running one, at most 1 [-].
double maturing_f_mat(int steps, const Laws& laws, const LawPlace& place = {});

/// f_mat of a protrusion; of a growing one 0 [-].
double f_mat_of(const Phase& phase, const Laws& laws, const LawPlace& place = {});

/// An adhesion that matures.
struct Loaded {
  int steps = 0;        ///< done so far
  double force = 0.0;   ///< of the adhesion [nN]
  double age = 0.0;     ///< of the phase [s]
  double loading = 0.0; ///< rate of the force in the last step [nN/s]
  double recoil = 0.0;  ///< speed of the tip towards its base [um/s]
  LawPlace place{};
};

/// Force of the adhesion at which the running step is done: laws.maturation_force, (f_mat - 0.1) F_am + step_threshold
/// x 0.1 F_am by default, with the F_am of maturation_force() [nN].
double step_force(const Loaded& now, const Laws& laws);

/// Whether the running step is done: the adhesion bears its force, and, if it is the first one, the recoil of growth is
/// over. While the matrix springs back, it carries the tip along, so that the adhesion bears F_mat although nothing
/// resists (MODEL.md, I19).
bool step_done(const Loaded& now, const Parameters& p, const Laws& laws);

/// How long ago the running step, which is done, was done: since the force passed step_force() within the step of dt.
/// Or, if it is the first one and the force has been there for longer, since the recoil was over: it is known as the
/// mean speed of a step, so that is dt on average [s].
double time_since_done(const Loaded& now, double dt, const Laws& laws);

/// f_mat at the end of maturation: laws.maturation, 0.1 (steps done + the part of the running one) by default, at least
/// that of the body, at most 1
/// [-]. The part of the running step is the time since the last one over the mean time of those done, at most 1, so
/// that this is the paper's 0.1 T_mat over the mean time of a step where steps come evenly; without a step, the part of
/// its force that is reached.
/// @param last_step  when the last step was done [s]
double final_f_mat(const Loaded& now, double last_step, const Parameters& p, const Laws& laws);

/// Adds the pull F_mat = f_mat F_am on the centre of each maturing protrusion, against d_prot; also the pull that is
/// left of F_mat in contracting protrusions, between the centre and both ends of the base.
/// @param places  of each particle of the cortex, for laws that use them
/// @param first   node of particle 0 of the cortex   @param force  of all nodes [nN]
void add_maturation(const Cell& cell, const Parameters& p, const Laws& laws, std::span<const LawPlace> places,
                    double dt, std::uint32_t first, std::span<Vec2> force, DragSystem& A);

/// Adds the high drag of pinned_particles at either end of each maturing protrusion: it pins the base.
/// @param first  as above
void pin_bases(const Cell& cell, const Parameters& p, std::uint32_t first, DragSystem& A);

/// An adhesion when its protrusion begins to contract (Heck et al. 2020, section "Maturation"; MODEL.md, I20): the
/// bundle takes over handover_share of f_mat F_am.
Contracting handover(const Maturing& maturing, double f_mat, double F, const Parameters& p);

/// The same after dt with a load F. What the last step of maturation loaded beyond f_mat F_am falls off first;
/// from then on the bundle gives way by what F exceeds that share, with the time constant handover_time (MODEL.md,
/// I20).
/// @param F  force of the adhesion [nN]
Contracting handed_over(Contracting phase, double F, const Parameters& p, double dt);

} // namespace matrigrate
