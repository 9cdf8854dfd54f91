#include "contact/viscous.hpp"

#include "ecm/loop/viscosity.hpp"
#include "sph/kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace matrigrate {

namespace {

/// Sample points of all segments, each of which represents part of its segment's volume; those of segment i are
/// first[i] .. first[i + 1] - 1.
struct Samples {
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> segment;
  std::vector<Vec2> x, along;        // a sample, and its segment as a vector [um]
  std::vector<std::uint8_t> soft;    // whether its segment grows or matures
  std::vector<double> s;             // position along the segment, 0 to 1 [-]
  std::vector<double> shared_volume; // of a sample and a particle; pair_drag takes V_i V_j as a square [um^2]
};

Samples samples(const CortexState& c, std::span<const std::uint8_t> soft, const Parameters& p, double V0) {
  Samples points;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vec2 e = c.x[c.next(i)] - c.x[i];
    const double l = e.norm();
    const int count = std::max(1, static_cast<int>(std::ceil(l / p.contact.sample_spacing)));
    const double volume = l / count * p.ecm.particle_spacing; // per depth [um^2]
    for (int m = 0; m < count; ++m) {
      points.segment.push_back(static_cast<std::uint32_t>(i));
      points.soft.push_back(soft[i]);
      points.s.push_back((m + 0.5) / count);
      points.x.emplace_back(c.x[i] + points.s.back() * e);
      points.along.push_back(e);
      points.shared_volume.push_back(std::sqrt(V0 * volume));
    }
    points.first.push_back(static_cast<std::uint32_t>(points.x.size()));
  }
  return points;
}

/// The samples within reach of a particle, as a structure of arrays.
struct NearbySamples {
  explicit NearbySamples(std::size_t capacity)
      : point(capacity), r2(capacity), share(capacity), shared_volume(capacity), G(capacity) {}

  std::size_t count = 0;
  std::vector<std::uint32_t> point;
  std::vector<double> r2, share, shared_volume; // squared distances [um^2], shares of the drag [-]
  std::vector<double> G;                        // drag coefficients [nN s/um]
};

/// Finds the samples of some segments within reach of x.
void find_near(const Vec2& x, std::span<const std::uint32_t> segments, const Samples& points, double reach,
               NearbySamples& near) {
  std::size_t count = 0;
  for (std::size_t begin = 0, end = 0; begin < segments.size(); begin = end) {
    for (end = begin + 1; end < segments.size() && segments[end] == segments[end - 1] + 1;) ++end; // consecutive ones
    for (std::uint32_t m = points.first[segments[begin]]; m < points.first[segments[end - 1] + 1]; ++m) {
      const double r2 = (x - points.x[m]).squaredNorm();
      near.point[count] = m;
      near.r2[count] = r2;
      count += r2 < reach * reach ? 1 : 0; // without a branch, which would be unpredictable
    }
  }
  near.count = count;
}

/// Sets the share of the drag that each sample exerts on particle k; removes samples whose share is 0.
void share_drag(const EcmState& ecm, std::uint32_t k, const Samples& points, const ContactParameters& p,
                NearbySamples& near) {
  const double inside = ecm.f[k];
  const std::array outside{inside + p.body_fluid_share * (1.0 - inside), inside + p.fluid_share * (1.0 - inside)};
  std::size_t count = 0;
  for (std::size_t n = 0; n < near.count; ++n) {
    const std::uint32_t m = near.point[n];
    const bool is_outside = cross(ecm.x[k] - points.x[m], points.along[m]) > 0.0; // the cortex runs counter-clockwise
    const double share = is_outside ? outside[points.soft[m]] : inside;
    near.share[count] = share;
    near.shared_volume[count] = points.shared_volume[m];
    near.point[count] = m;
    near.r2[count] = near.r2[n];
    count += share > 0.0 ? 1 : 0;
  }
  near.count = count;
}

/// Evaluates the drag coefficient of each sample.
MATRIGRATE_SIMD
void evaluate_drag(const EcmParameters& p, const Kernel& kernel, NearbySamples& near) {
  const double viscosity = p.viscosity, thickness = p.thickness;
  const double *r2 = near.r2.data(), *share = near.share.data(), *volume = near.shared_volume.data();
  double* __restrict G = near.G.data();
  for (std::size_t n = 0; n < near.count; ++n)
    G[n] = share[n] * pair_drag(r2[n], kernel.W_slope(std::sqrt(r2[n])), volume[n], viscosity, thickness, kernel.h());
}

} // namespace

void add_viscous_contact(const EcmState& ecm, const CortexState& c, std::span<const std::uint8_t> soft,
                         const Parameters& p, const SegmentGrid& grid, std::uint32_t first, DragSystem& A) {
  const Kernel kernel(p.ecm.smoothing_length);
  const Samples points = samples(c, soft, p, ecm.V0);
  const bool in_fluid = std::max(p.contact.fluid_share, p.contact.body_fluid_share) > 0.0;
  NearbySamples near(points.x.size() + 1); // the entry after the last is written before it is known to count
  for (const std::uint32_t k : grid.candidates(ecm.x)) {
    const bool rigid = ecm.in_obstacle(k);
    if ((ecm.clamped[k] && !rigid) || (ecm.f[k] <= 0.0 && !in_fluid)) continue;
    find_near(ecm.x[k], grid.near(ecm.x[k]), points, kernel.support(), near);
    share_drag(ecm, k, points, p.contact, near);
    evaluate_drag(p.ecm, kernel, near);
    for (std::size_t n = 0; n < near.count; ++n) {
      const std::size_t i = points.segment[near.point[n]];
      const double s = points.s[near.point[n]];
      if (!rigid) A.links.add_entry(k, 1.0);
      A.links.add_entry(first + static_cast<std::uint32_t>(i), -(1.0 - s));
      A.links.add_entry(first + static_cast<std::uint32_t>(c.next(i)), -s);
      A.links.close(near.G[n]);
    }
  }
}

} // namespace matrigrate
