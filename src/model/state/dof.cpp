#include "state/dof.hpp"

namespace matrigrate {

std::uint32_t first_node(const State& s, std::size_t cell) {
  std::size_t node = s.ecm.size();
  for (std::size_t k = 0; k < cell; ++k) node += s.cells[k].cortex.size() + s.cells[k].nucleus.size();
  return static_cast<std::uint32_t>(node);
}

std::uint32_t first_nucleus_node(const State& s, std::size_t cell) {
  return first_node(s, cell) + static_cast<std::uint32_t>(s.cells[cell].cortex.size());
}

std::size_t node_count(const State& s) { return first_node(s, s.cells.size()); }

std::size_t cortex_particles(const State& s) {
  std::size_t n = 0;
  for (const Cell& cell : s.cells) n += cell.cortex.size();
  return n;
}

const Vec2& node_position(const State& s, std::size_t node) {
  if (in_matrix(s, node)) return s.ecm.x[node];
  std::size_t i = node - s.ecm.size();
  for (const Cell& cell : s.cells)
    for (const CortexState* ring : {&cell.cortex, &cell.nucleus}) {
      if (i < ring->size()) return ring->x[i];
      i -= ring->size();
    }
  return s.cells.back().cortex.x.at(i); // throws: there is no such node
}

std::vector<Vec2> node_velocities(const State& s) {
  std::vector<Vec2> v;
  node_velocities(s, v);
  return v;
}

void node_velocities(const State& s, std::vector<Vec2>& v) {
  v.reserve(node_count(s));
  v.assign(s.ecm.v.begin(), s.ecm.v.end());
  for (const Cell& cell : s.cells)
    for (const CortexState* ring : {&cell.cortex, &cell.nucleus}) v.insert(v.end(), ring->v.begin(), ring->v.end());
}

} // namespace matrigrate
