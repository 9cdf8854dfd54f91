#include "state/dof.hpp"

namespace matrigrate {

std::uint32_t first_node(const State& s, std::size_t cell) {
  std::size_t node = s.ecm.size();
  for (std::size_t k = 0; k < cell; ++k) node += s.cells[k].cortex.size();
  return static_cast<std::uint32_t>(node);
}

std::size_t node_count(const State& s) { return first_node(s, s.cells.size()); }

const Vec2& node_position(const State& s, std::size_t node) {
  if (in_matrix(s, node)) return s.ecm.x[node];
  std::size_t i = node - s.ecm.size();
  std::size_t cell = 0;
  while (i >= s.cells[cell].cortex.size()) i -= s.cells[cell++].cortex.size();
  return s.cells[cell].cortex.x[i];
}

std::vector<Vec2> node_velocities(const State& s) {
  std::vector<Vec2> v = s.ecm.v;
  v.reserve(node_count(s));
  for (const Cell& cell : s.cells) v.insert(v.end(), cell.cortex.v.begin(), cell.cortex.v.end());
  return v;
}

void set_node_velocities(State& s, std::span<const Vec2> v) {
  const auto take = [&v](std::size_t n, std::vector<Vec2>& to) {
    to.assign(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n));
    v = v.subspan(n);
  };
  take(s.ecm.size(), s.ecm.v);
  for (Cell& cell : s.cells) take(cell.cortex.size(), cell.cortex.v);
}

} // namespace matrigrate
