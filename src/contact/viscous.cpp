#include "contact/viscous.hpp"

#include "ecm/loop/viscosity.hpp"
#include "sph/kernel.hpp"

#include <cmath>
#include <vector>

namespace matrigrate {

namespace {

/// A point of a segment that stands for part of its volume.
struct Sample {
  Vec2 x;
  double s;      // along the segment
  double volume; // per depth [um^2]
};

/// Samples of all segments; those of segment i are first[i] .. first[i + 1] - 1.
struct Samples {
  std::vector<Sample> all;
  std::vector<std::size_t> first{0};
};

Samples samples(const CortexState& c, const Parameters& p) {
  Samples result;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vec2 e = c.x[c.next(i)] - c.x[i];
    const double l = e.norm();
    const int count = std::max(1, static_cast<int>(std::ceil(l / p.contact.sample_spacing)));
    for (int m = 0; m < count; ++m) {
      const double s = (m + 0.5) / count;
      result.all.push_back({c.x[i] + s * e, s, l / count * p.ecm.particle_spacing});
    }
    result.first.push_back(result.all.size());
  }
  return result;
}

} // namespace

void add_viscous_contact(const EcmState& ecm, const CortexState& c, const Parameters& p, const SegmentGrid& grid,
                         std::uint32_t first, DragSystem& A) {
  const Kernel kernel(p.ecm.smoothing_length);
  const double reach2 = kernel.support() * kernel.support();
  const Samples points = samples(c, p);
  for (const std::uint32_t k : grid.candidates(ecm.x)) {
    const bool rigid = ecm.in_obstacle(k);
    if ((ecm.clamped[k] && !rigid) || (ecm.f[k] <= 0.0 && p.contact.fluid_share <= 0.0)) continue;
    for (const std::uint32_t i : grid.near(ecm.x[k])) {
      const std::uint32_t a = first + i;
      const std::uint32_t b = first + static_cast<std::uint32_t>(c.next(i));
      const Vec2 e = c.x[c.next(i)] - c.x[i];
      for (std::size_t m = points.first[i]; m < points.first[i + 1]; ++m) {
        const Sample& point = points.all[m];
        const Vec2 d = ecm.x[k] - point.x;
        const double r2 = d.squaredNorm();
        if (r2 >= reach2) continue;
        const bool outside = d.x() * e.y() - d.y() * e.x() > 0.0; // the cortex runs counter-clockwise
        const double share = ecm.f[k] + (outside ? p.contact.fluid_share * (1.0 - ecm.f[k]) : 0.0);
        if (share <= 0.0) continue;
        const double shared_volume = std::sqrt(ecm.V0 * point.volume); // pair_drag takes V_i V_j as a square
        const double G =
            share
            * pair_drag(r2, kernel.W_slope(std::sqrt(r2)), shared_volume, p.ecm.viscosity, p.ecm.thickness, kernel.h());
        if (!rigid) A.links.add_entry(k, 1.0);
        A.links.add_entry(a, -(1.0 - point.s));
        A.links.add_entry(b, -point.s);
        A.links.close(G);
      }
    }
  }
}

} // namespace matrigrate
