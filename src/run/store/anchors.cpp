#include "store/anchors.hpp"

#include <cmath>

namespace matrigrate::store {

Anchors anchors(const observe::Frame& frame) {
  const observe::ProtrusionFrame& p = frame.protrusions;
  Anchors all;
  for (std::size_t i = 0; i < p.id.size(); ++i) {
    if (std::isnan(p.anchor[2 * i])) continue;
    all.x.insert(all.x.end(), {p.anchor[2 * i], p.anchor[2 * i + 1]});
    all.id.push_back(p.id[i]);
    all.f_mat.push_back(p.f_mat[i]);
    all.force.push_back(p.force[i]);
  }
  return all;
}

} // namespace matrigrate::store
