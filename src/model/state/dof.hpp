#pragma once

#include "state/state.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// The nodes of the drag system A v = F: first the particles of the matrix, node i being particle i; then the particles
/// of each cell, in the order of State::cells: those of its cortex and those of its nucleus. Each node has two degrees
/// of freedom. Only this header knows the numbering. Test: tests/unit/state/state_test.cpp
namespace matrigrate {

/// Number of nodes.
std::size_t node_count(const State& s);

/// Node of particle 0 of the cortex of a cell; those of its other particles follow.
/// @param cell  index into State::cells; their number: the node behind all
std::uint32_t first_node(const State& s, std::size_t cell);

/// Node of particle 0 of the nucleus of a cell; those of its other particles follow.
std::uint32_t first_nucleus_node(const State& s, std::size_t cell);

/// Number of particles of all cortices.
std::size_t cortex_particles(const State& s);

/// Whether a node is a particle of the matrix.
inline bool in_matrix(const State& s, std::size_t node) { return node < s.ecm.size(); }

/// Position of a node [um].
const Vec2& node_position(const State& s, std::size_t node);

/// The entries of the cortex of a cell among values of all nodes.
template <class T>
std::span<T> of_cell(const State& s, std::size_t cell, std::span<T> values) {
  return values.subspan(first_node(s, cell), s.cells[cell].cortex.size());
}

/// Those of its nucleus.
template <class T>
std::span<T> of_nucleus(const State& s, std::size_t cell, std::span<T> values) {
  return values.subspan(first_nucleus_node(s, cell), s.cells[cell].nucleus.size());
}

/// Velocities of all nodes [um/s].
std::vector<Vec2> node_velocities(const State& s);

/// The same, into v, whose memory is reused.
void node_velocities(const State& s, std::vector<Vec2>& v);

} // namespace matrigrate
