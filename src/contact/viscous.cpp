#include "contact/viscous.hpp"

#include "ecm/loop/viscosity.hpp"
#include "sph/kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace matrigrate {

namespace {

/// Points of all segments, each of which stands for part of its segment's volume; those of segment i are first[i] ..
/// first[i + 1] - 1.
struct Samples {
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> segment;
  std::vector<Vec2> x, along;        // a point, and its segment from end to end [um]
  std::vector<double> s;             // along the segment
  std::vector<double> shared_volume; // of a point and a particle; pair_drag takes V_i V_j as a square [um^2]
};

Samples samples(const CortexState& c, const Parameters& p, double V0) {
  Samples points;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vec2 e = c.x[c.next(i)] - c.x[i];
    const double l = e.norm();
    const int count = std::max(1, static_cast<int>(std::ceil(l / p.contact.sample_spacing)));
    const double volume = l / count * p.ecm.particle_spacing; // per depth [um^2]
    for (int m = 0; m < count; ++m) {
      points.segment.push_back(static_cast<std::uint32_t>(i));
      points.s.push_back((m + 0.5) / count);
      points.x.emplace_back(c.x[i] + points.s.back() * e);
      points.along.push_back(e);
      points.shared_volume.push_back(std::sqrt(V0 * volume));
    }
    points.first.push_back(static_cast<std::uint32_t>(points.x.size()));
  }
  return points;
}

/// The points that drag a particle.
struct Meetings {
  explicit Meetings(std::size_t most) : point(most), r2(most), share(most), shared_volume(most), G(most) {}

  std::size_t count = 0;
  std::vector<std::uint32_t> point;
  std::vector<double> r2, share, shared_volume; // squares of distances [um^2], shares of the drag [-]
  std::vector<double> G;                        // drag [nN s/um]
};

/// Finds the points of some segments within reach of x.
void find_near(const Vec2& x, std::span<const std::uint32_t> segments, const Samples& points, double reach,
               Meetings& met) {
  std::size_t count = 0;
  for (std::size_t begin = 0, end = 0; begin < segments.size(); begin = end) {
    for (end = begin + 1; end < segments.size() && segments[end] == segments[end - 1] + 1;) ++end; // in one go
    for (std::uint32_t m = points.first[segments[begin]]; m < points.first[segments[end - 1] + 1]; ++m) {
      const double r2 = (x - points.x[m]).squaredNorm();
      met.point[count] = m;
      met.r2[count] = r2;
      count += r2 < reach * reach ? 1 : 0; // without a branch, which nobody could foretell
    }
  }
  met.count = count;
}

/// Shares of their drag that the points exert on a particle; leaves out those that exert none.
void share_drag(const EcmState& ecm, std::uint32_t k, const Samples& points, double fluid_share, Meetings& met) {
  const double inside = ecm.f[k], outside = ecm.f[k] + fluid_share * (1.0 - ecm.f[k]);
  std::size_t count = 0;
  for (std::size_t n = 0; n < met.count; ++n) {
    const std::uint32_t m = met.point[n];
    const bool is_outside = cross(ecm.x[k] - points.x[m], points.along[m]) > 0.0; // the cortex runs counter-clockwise
    const double share = is_outside ? outside : inside;
    met.share[count] = share;
    met.shared_volume[count] = points.shared_volume[m];
    met.point[count] = m;
    met.r2[count] = met.r2[n];
    count += share > 0.0 ? 1 : 0;
  }
  met.count = count;
}

/// Drag of each meeting.
MATRIGRATE_SIMD
void evaluate_drag(const EcmParameters& p, const Kernel& kernel, Meetings& met) {
  const double viscosity = p.viscosity, thickness = p.thickness;
  const double *r2 = met.r2.data(), *share = met.share.data(), *volume = met.shared_volume.data();
  double* __restrict G = met.G.data();
  for (std::size_t n = 0; n < met.count; ++n)
    G[n] = share[n] * pair_drag(r2[n], kernel.W_slope(std::sqrt(r2[n])), volume[n], viscosity, thickness, kernel.h());
}

} // namespace

void add_viscous_contact(const EcmState& ecm, const CortexState& c, const Parameters& p, const SegmentGrid& grid,
                         std::uint32_t first, DragSystem& A) {
  const Kernel kernel(p.ecm.smoothing_length);
  const Samples points = samples(c, p, ecm.V0);
  Meetings met(points.x.size() + 1); // one that does not count may stand behind all others
  for (const std::uint32_t k : grid.candidates(ecm.x)) {
    const bool rigid = ecm.in_obstacle(k);
    if ((ecm.clamped[k] && !rigid) || (ecm.f[k] <= 0.0 && p.contact.fluid_share <= 0.0)) continue;
    find_near(ecm.x[k], grid.near(ecm.x[k]), points, kernel.support(), met);
    share_drag(ecm, k, points, p.contact.fluid_share, met);
    evaluate_drag(p.ecm, kernel, met);
    for (std::size_t n = 0; n < met.count; ++n) {
      const std::size_t i = points.segment[met.point[n]];
      const double s = points.s[met.point[n]];
      if (!rigid) A.links.add_entry(k, 1.0);
      A.links.add_entry(first + static_cast<std::uint32_t>(i), -(1.0 - s));
      A.links.add_entry(first + static_cast<std::uint32_t>(c.next(i)), -s);
      A.links.close(met.G[n]);
    }
  }
}

} // namespace matrigrate
