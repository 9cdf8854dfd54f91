#pragma once

#include "state/matrix_field.hpp"
#include "state/state.hpp"

#include <concepts>
#include <type_traits>
#include <vector>

/// The members of the state, each once, with its name in files and its unit. Checkpoint, image, consistency check and
/// the comparison of bits visit these lists. Test: tests/unit/store/every_member_test.cpp
namespace matrigrate {

/// Name and unit of a member.
struct StateMember {
  const char* name;
  const char* unit = "";
  bool may_be_empty = false; ///< of an array with one entry a particle: empty where the matrix has no such field
};

template <class T, class Of>
concept Like = std::same_as<std::remove_const_t<T>, Of>;

void each_member(Like<Growing> auto& s, auto&& visit) {
  visit(StateMember{"direction", "1"}, s.direction);
  visit(StateMember{"base_width", "um"}, s.base_width);
}

void each_member(Like<Maturing> auto& s, auto&& visit) {
  visit(StateMember{"direction", "1"}, s.direction);
  visit(StateMember{"anchor", "um"}, s.anchor);
  visit(StateMember{"steps"}, s.steps);
  visit(StateMember{"last_step", "s"}, s.last_step);
  visit(StateMember{"held", "um"}, s.held);
}

void each_member(Like<Contracting> auto& s, auto&& visit) {
  visit(StateMember{"anchor", "um"}, s.anchor);
  visit(StateMember{"f_mat", "1"}, s.f_mat);
  visit(StateMember{"bundle", "nN"}, s.bundle);
  visit(StateMember{"falling", "nN"}, s.falling);
  visit(StateMember{"held", "um"}, s.held);
}

void each_member(Like<Finishing> auto& s, auto&& visit) { visit(StateMember{"f_mat", "1"}, s.f_mat); }

void each_member(Like<ProtrusionRecord> auto& s, auto&& visit) {
  visit(StateMember{"id"}, s.id);
  visit(StateMember{"centre"}, s.centre);
  visit(StateMember{"t_initiation", "s"}, s.t_initiation);
  visit(StateMember{"t_adhesion", "s"}, s.t_adhesion);
  visit(StateMember{"t_mature", "s"}, s.t_mature);
  visit(StateMember{"t_disassembly", "s"}, s.t_disassembly);
  visit(StateMember{"t_end", "s"}, s.t_end);
  visit(StateMember{"length", "um"}, s.length);
  visit(StateMember{"direction", "rad"}, s.direction);
  visit(StateMember{"f_mat", "1"}, s.f_mat);
  visit(StateMember{"force", "nN"}, s.force);
  visit(StateMember{"cause"}, s.cause);
}

void each_member(Like<Protrusion> auto& s, auto&& visit) {
  visit(StateMember{"centre"}, s.centre);
  visit(StateMember{"since", "s"}, s.since);
  visit(StateMember{"phase"}, s.phase);
  visit(StateMember{"record"}, s.record);
}

void each_member(Like<CortexState> auto& s, auto&& visit) {
  visit(StateMember{"x", "um"}, s.x);
  visit(StateMember{"v", "um/s"}, s.v);
  visit(StateMember{"l0", "um"}, s.l0);
}

void each_member(Like<Cell> auto& s, auto&& visit) {
  visit(StateMember{"id"}, s.id);
  visit(StateMember{"cortex"}, s.cortex);
  visit(StateMember{"nucleus"}, s.nucleus);
  visit(StateMember{"protrusions"}, s.protrusions);
  visit(StateMember{"ended"}, s.ended);
  visit(StateMember{"polarization", "rad"}, s.polarization);
  visit(StateMember{"initiated"}, s.initiated);
}

void each_member(Like<EcmState> auto& s, auto&& visit) {
  constexpr bool may_be_empty = true;
  visit(StateMember{"V0", "um^2"}, s.V0);
  visit(StateMember{"period_x", "um"}, s.period_x);
  visit(StateMember{"X", "um"}, s.X);
  visit(StateMember{"x", "um"}, s.x);
  visit(StateMember{"v", "um/s"}, s.v);
  visit(StateMember{"rho", "1"}, s.rho);
  visit(StateMember{"S", "kPa"}, s.S);
  visit(StateMember{"f", "1"}, s.f);
  visit(StateMember{"attractant", "1", may_be_empty}, s.attractant);
  visit(StateMember{"clamped"}, s.clamped);
  for (const MatrixField& field : matrix_field_table)
    visit(StateMember{field.name.data(), field.unit.data(), may_be_empty}, s.*field.member);
  visit(StateMember{"obstacle", "", may_be_empty}, s.obstacle);
}

void each_member(Like<SolverMemory> auto& s, auto&& visit) {
  visit(StateMember{"v_before", "um/s"}, s.v_before);
  visit(StateMember{"x_drag", "um"}, s.x_drag);
}

void each_member(Like<State> auto& s, auto&& visit) {
  visit(StateMember{"step"}, s.step);
  visit(StateMember{"t", "s"}, s.t);
  visit(StateMember{"ecm"}, s.ecm);
  visit(StateMember{"cells"}, s.cells);
  visit(StateMember{"solver_memory"}, s.solver_memory);
}

/// A struct with a list above.
template <class T>
concept Listed = requires(T& s) {
  each_member(s, [](const StateMember&, auto&) {});
};

template <class T>
inline constexpr bool is_array = false;
template <class T>
inline constexpr bool is_array<std::vector<T>> = !Listed<T>;

/// A member that is an array of numbers, vectors or matrices.
template <class T>
concept Array = is_array<std::remove_const_t<T>>;

} // namespace matrigrate
