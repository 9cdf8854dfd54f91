#include "cell/rest_length.hpp"

namespace matrigrate {

void ratchet_rest_lengths(CortexState& c, const CellParameters& p, std::span<const std::uint8_t> soft) {
  const double l0_init = initial_segment_length(p);
  for (std::size_t i = 0; i < c.size(); ++i)
    if (!soft[i]) c.l0[i] = ratcheted(c.l0[i], (c.x[c.next(i)] - c.x[i]).norm(), l0_init);
}

} // namespace matrigrate
