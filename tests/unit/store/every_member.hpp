#pragma once

#include "state/state.hpp"
#include "store/checkpoint.hpp"
#include "store/run_memory.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

/// Fills archived structs with distinct values and lists what they hold, member by member. A struct that gets another
/// member no longer compiles here until the member is named below, and is then filled and compared like the others.
namespace matrigrate::every_member {

inline auto members(Growing& s) {
  auto& [direction, base_width] = s;
  return std::tie(direction, base_width);
}
inline auto members(Maturing& s) {
  auto& [direction, anchor, steps, last_step, held] = s;
  return std::tie(direction, anchor, steps, last_step, held);
}
inline auto members(Contracting& s) {
  auto& [anchor, f_mat, bundle, falling, held] = s;
  return std::tie(anchor, f_mat, bundle, falling, held);
}
inline auto members(Finishing& s) {
  auto& [f_mat] = s;
  return std::tie(f_mat);
}
inline auto members(ProtrusionRecord& s) {
  auto& [id, centre, initiation, adhesion, mature, disassembly, end, length, direction, f_mat, force, cause] = s;
  return std::tie(id, centre, initiation, adhesion, mature, disassembly, end, length, direction, f_mat, force, cause);
}
inline auto members(Protrusion& s) {
  auto& [centre, since, phase, record] = s;
  return std::tie(centre, since, phase, record);
}
inline auto members(CortexState& s) {
  auto& [x, v, l0] = s;
  return std::tie(x, v, l0);
}
inline auto members(Cell& s) {
  auto& [id, cortex, nucleus, protrusions, ended, polarization, initiated] = s;
  return std::tie(id, cortex, nucleus, protrusions, ended, polarization, initiated);
}
inline auto members(EcmState& s) {
  auto& [V0, period_x, X, x, v, rho, S, f, attractant, clamped, E_ratio, fibre_direction, fibre_ratio, ligand, source,
         obstacle] = s;
  return std::tie(V0, period_x, X, x, v, rho, S, f, attractant, clamped, E_ratio, fibre_direction, fibre_ratio, ligand,
                  source, obstacle);
}
inline auto members(SolverMemory& s) {
  auto& [v_before, x_drag] = s;
  return std::tie(v_before, x_drag);
}
inline auto members(State& s) {
  auto& [step, t, ecm, cells, solver_memory] = s;
  return std::tie(step, t, ecm, cells, solver_memory);
}
inline auto members(store::Checkpoint& s) {
  auto& [state, scenario, configuration_hash, program, memory] = s;
  return std::tie(state, scenario, configuration_hash, program, memory);
}
inline auto members(NucleusRow& s) {
  auto& [centre, area, aspect] = s;
  return std::tie(centre, area, aspect);
}
inline auto members(TrackRow& s) {
  auto& [t, step, cell, centre, area, perimeter, polarization, in_phase, initiated, nucleus] = s;
  return std::tie(t, step, cell, centre, area, perimeter, polarization, in_phase, initiated, nucleus);
}
inline auto members(GroupRow& s) {
  auto& [t, step, centre, spread, speed, order, direction, nearest, gap, contacts] = s;
  return std::tie(t, step, centre, spread, speed, order, direction, nearest, gap, contacts);
}
inline auto members(HealthWatch& s) {
  auto& [max_iterations, largest_residual] = s;
  return std::tie(max_iterations, largest_residual);
}
inline auto members(SolveReport& s) {
  auto& [iterations, residual, converged] = s;
  return std::tie(iterations, residual, converged);
}
inline auto members(StepHealth& s) {
  auto& [solve, density_bounds, orphans, torn, engulfed, list_builds] = s;
  return std::tie(solve, density_bounds, orphans, torn, engulfed, list_builds);
}
inline auto members(store::RunMemory& s) {
  auto& [tables, rows, group, watch, counts, step, force_imbalance, frames, trajectory, march_wall_time] = s;
  return std::tie(tables, rows, group, watch, counts, step, force_imbalance, frames, trajectory, march_wall_time);
}

inline constexpr std::size_t list_length = 4; ///< as many as there are phases: each occurs

/// Gives each number another value; lists get four entries.
class Filler {
public:
  template <class T>
  void fill(T& value) {
    if constexpr (std::is_same_v<T, bool>)
      value = true;
    else if constexpr (std::is_same_v<T, std::uint8_t>)
      value = static_cast<std::uint8_t>(1 + ++m_count % 250);
    else if constexpr (std::is_integral_v<T>)
      value = static_cast<T>(++m_count);
    else if constexpr (std::is_floating_point_v<T>)
      value = ++m_count / 3.0;
    else if constexpr (std::is_same_v<T, std::string>)
      value = fmt::format("text {}", ++m_count);
    else if constexpr (std::is_enum_v<T>)
      value = static_cast<T>(1 + ++m_count % 4);
    else
      std::apply([this](auto&... member) { (this->fill(member), ...); }, members(value));
  }
  void fill(Vec2& value) {
    fill(value.x());
    fill(value.y());
  }
  void fill(Mat2& value) {
    for (double& number : value.reshaped()) fill(number);
  }
  void fill(Phase& phase) {
    switch (++m_phase % 4) {
    case 0:
      phase = Growing();
      break;
    case 1:
      phase = Maturing();
      break;
    case 2:
      phase = Contracting();
      break;
    default:
      phase = Finishing();
    }
    std::visit([this](auto& one) { this->fill(one); }, phase);
  }
  template <class T>
  void fill(std::optional<T>& value) {
    fill(value.emplace());
  }
  template <class T>
  void fill(std::vector<T>& list) {
    list.resize(list_length);
    for (T& one : list) fill(one);
  }
  template <class T, std::size_t n>
  void fill(std::array<T, n>& list) {
    for (T& one : list) fill(one);
  }
  void fill(std::map<std::string, std::string>& /*tables*/) {} // whose rows are in files

private:
  int m_count = 0;
  int m_phase = 0;
};

/// Changes one number of a struct by its last bits, a phase to the next one, or takes an optional number away.
class Changer {
public:
  /// @param at  which of them, from 0, in the order of the members
  explicit Changer(std::size_t at) : m_left(at) {}

  bool done() const { return m_done; }

  template <class T>
  void change(T& value) {
    if constexpr (std::is_floating_point_v<T>) {
      if (here()) value = std::nextafter(value, 0.0);
    } else if constexpr (std::is_integral_v<T>) {
      if (here()) value = static_cast<T>(value > 0 ? value - 1 : 1);
    } else if constexpr (std::is_enum_v<T>) {
      if (here()) value = static_cast<T>(static_cast<int>(value) - 1);
    } else {
      std::apply([this](auto&... member) { (this->change(member), ...); }, members(value));
    }
  }
  void change(Vec2& value) {
    change(value.x());
    change(value.y());
  }
  void change(Mat2& value) {
    for (double& number : value.reshaped()) change(number);
  }
  void change(Phase& phase) {
    if (here())
      phase = std::holds_alternative<Finishing>(phase) ? Phase(Growing()) : Phase(Finishing());
    else
      std::visit([this](auto& one) { this->change(one); }, phase);
  }
  void change(std::optional<double>& value) {
    if (here())
      value.reset();
    else if (value)
      change(*value);
  }
  template <class T>
  void change(std::vector<T>& list) {
    for (T& one : list) change(one);
  }

private:
  bool here() {
    const bool now = !m_done && m_left == 0;
    m_done = m_done || now;
    if (!m_done) --m_left;
    return now;
  }

  std::size_t m_left;
  bool m_done = false;
};

/// All that a value holds, as text, a number with all its digits.
struct Lister {
  std::string operator()(Vec2& value) const { return fmt::format("({} {})", value.x(), value.y()); }
  std::string operator()(Mat2& A) const { return fmt::format("({} {} {} {})", A(0, 0), A(0, 1), A(1, 0), A(1, 1)); }
  std::string operator()(Phase& phase) const { return std::string(name(phase)) + std::visit(*this, phase); }
  template <class T>
  std::string operator()(std::optional<T>& value) const {
    return value ? (*this)(*value) : "none";
  }
  template <class T>
  std::string operator()(std::vector<T>& list) const {
    return entries(list);
  }
  template <class T, std::size_t n>
  std::string operator()(std::array<T, n>& list) const {
    return entries(list);
  }
  std::string operator()(std::map<std::string, std::string>& tables) const {
    std::string text;
    for (const auto& [name, rows] : tables) text += name + ":\n" + rows;
    return text;
  }
  template <class T>
  std::string operator()(T& value) const {
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>)
      return fmt::format("{}", value);
    else if constexpr (std::is_enum_v<T>)
      return std::string(name(value));
    else
      return "{" + std::apply([this](auto&... member) { return (((*this)(member) + " ") + ...); }, members(value))
             + "}\n";
  }

private:
  template <class List>
  std::string entries(List& list) const {
    std::string text = "[";
    for (auto& one : list) text += (*this)(one) + " ";
    return text + "]";
  }
};

template <class T>
std::string listed(T& value) {
  return Lister()(value);
}

} // namespace matrigrate::every_member
