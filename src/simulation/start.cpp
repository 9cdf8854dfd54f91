#include "simulation/start.hpp"

#include "simulation/start_fields.hpp"

namespace matrigrate {

State initial_state(const Parameters& p) {
  State s;
  s.ecm = disc(p);
  apply(matrix_fields(p), s.ecm);
  s.cells.emplace_back().cortex = round_cortex(p.cell);
  return s;
}

} // namespace matrigrate
