#include "simulation/start.hpp"

#include "cell/nucleus.hpp"
#include "simulation/start_fields.hpp"

#include <cstdint>

namespace matrigrate {

State initial_state(const Parameters& p) {
  State s;
  s.ecm = disc(p);
  apply(matrix_fields(p), s.ecm);
  for (const CellStart& start : cell_starts(p)) {
    const auto id = static_cast<std::uint32_t>(s.cells.size());
    Cell& cell = s.cells.emplace_back();
    cell.id = id;
    cell.cortex = round_cortex(p.cell, start);
    cell.nucleus = round_nucleus(p, start);
  }
  return s;
}

} // namespace matrigrate
