#include "simulation/start.hpp"

#include "state/initial.hpp"

namespace matrigrate {

State initial_state(const Parameters& p) {
  State s;
  s.ecm = disc(p);
  s.cells.emplace_back().cortex = round_cortex(p.cell);
  return s;
}

} // namespace matrigrate
