#pragma once

#include "state/state.hpp"

#include <concepts>
#include <type_traits>
#include <vector>

/// The members of the state, each once, with its name in files and its unit. Checkpoint, image, consistency check and
/// the comparison of bits visit these lists. Test: tests/unit/store/every_member_test.cpp
namespace matrigrate {

/// Name and unit of a member.
struct Member {
  const char* name;
  const char* unit = "";
  bool may_be_empty = false; ///< of an array with one entry a particle: empty where the matrix has no such field
};

template <class T, class Of>
concept Like = std::same_as<std::remove_const_t<T>, Of>;

void each_member(Like<Growing> auto& s, auto&& visit) {
  visit(Member{"direction", "1"}, s.direction);
  visit(Member{"base_width", "um"}, s.base_width);
}

void each_member(Like<Maturing> auto& s, auto&& visit) {
  visit(Member{"direction", "1"}, s.direction);
  visit(Member{"anchor", "um"}, s.anchor);
  visit(Member{"steps"}, s.steps);
  visit(Member{"last_step", "s"}, s.last_step);
  visit(Member{"held", "um"}, s.held);
}

void each_member(Like<Contracting> auto& s, auto&& visit) {
  visit(Member{"anchor", "um"}, s.anchor);
  visit(Member{"f_mat", "1"}, s.f_mat);
  visit(Member{"bundle", "nN"}, s.bundle);
  visit(Member{"falling", "nN"}, s.falling);
  visit(Member{"held", "um"}, s.held);
}

void each_member(Like<Finishing> auto& s, auto&& visit) { visit(Member{"f_mat", "1"}, s.f_mat); }

void each_member(Like<ProtrusionRecord> auto& s, auto&& visit) {
  visit(Member{"id"}, s.id);
  visit(Member{"centre"}, s.centre);
  visit(Member{"t_initiation", "s"}, s.t_initiation);
  visit(Member{"t_adhesion", "s"}, s.t_adhesion);
  visit(Member{"t_mature", "s"}, s.t_mature);
  visit(Member{"t_disassembly", "s"}, s.t_disassembly);
  visit(Member{"t_end", "s"}, s.t_end);
  visit(Member{"length", "um"}, s.length);
  visit(Member{"direction", "rad"}, s.direction);
  visit(Member{"f_mat", "1"}, s.f_mat);
  visit(Member{"force", "nN"}, s.force);
  visit(Member{"cause"}, s.cause);
}

void each_member(Like<Protrusion> auto& s, auto&& visit) {
  visit(Member{"centre"}, s.centre);
  visit(Member{"since", "s"}, s.since);
  visit(Member{"phase"}, s.phase);
  visit(Member{"record"}, s.record);
}

void each_member(Like<CortexState> auto& s, auto&& visit) {
  visit(Member{"x", "um"}, s.x);
  visit(Member{"v", "um/s"}, s.v);
  visit(Member{"l0", "um"}, s.l0);
}

void each_member(Like<Cell> auto& s, auto&& visit) {
  visit(Member{"id"}, s.id);
  visit(Member{"cortex"}, s.cortex);
  visit(Member{"nucleus"}, s.nucleus);
  visit(Member{"protrusions"}, s.protrusions);
  visit(Member{"ended"}, s.ended);
  visit(Member{"polarization", "rad"}, s.polarization);
  visit(Member{"initiated"}, s.initiated);
}

void each_member(Like<EcmState> auto& s, auto&& visit) {
  constexpr bool may_be_empty = true;
  visit(Member{"V0", "um^2"}, s.V0);
  visit(Member{"period_x", "um"}, s.period_x);
  visit(Member{"X", "um"}, s.X);
  visit(Member{"x", "um"}, s.x);
  visit(Member{"v", "um/s"}, s.v);
  visit(Member{"rho", "1"}, s.rho);
  visit(Member{"S", "kPa"}, s.S);
  visit(Member{"f", "1"}, s.f);
  visit(Member{"attractant", "1", may_be_empty}, s.attractant);
  visit(Member{"clamped"}, s.clamped);
  visit(Member{"E_ratio", "1", may_be_empty}, s.E_ratio);
  visit(Member{"fibre_direction", "rad", may_be_empty}, s.fibre_direction);
  visit(Member{"fibre_ratio", "1", may_be_empty}, s.fibre_ratio);
  visit(Member{"ligand", "1", may_be_empty}, s.ligand);
  visit(Member{"attractant_source", "1/s", may_be_empty}, s.attractant_source);
  visit(Member{"obstacle", "", may_be_empty}, s.obstacle);
}

void each_member(Like<SolverMemory> auto& s, auto&& visit) {
  visit(Member{"v_before", "um/s"}, s.v_before);
  visit(Member{"x_drag", "um"}, s.x_drag);
}

void each_member(Like<State> auto& s, auto&& visit) {
  visit(Member{"step"}, s.step);
  visit(Member{"t", "s"}, s.t);
  visit(Member{"ecm"}, s.ecm);
  visit(Member{"cells"}, s.cells);
  visit(Member{"solver_memory"}, s.solver_memory);
}

/// A struct with a list above.
template <class T>
concept Listed = requires(T& s) {
  each_member(s, [](const Member&, auto&) {});
};

template <class T>
inline constexpr bool is_array = false;
template <class T>
inline constexpr bool is_array<std::vector<T>> = !Listed<T>;

/// A member that is an array of numbers, vectors or matrices.
template <class T>
concept Array = is_array<std::remove_const_t<T>>;

} // namespace matrigrate
