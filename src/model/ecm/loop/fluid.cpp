#include "ecm/loop/fluid.hpp"

#include "base/parallel.hpp"
#include "ecm/law/material.hpp"
#include "state/initial.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace matrigrate {

namespace {

/// Up to `capacity` neighbours within reach of a particle, as a structure of arrays.
struct Near {
  static constexpr std::size_t capacity = 64;

  std::size_t count;
  std::uint32_t j[capacity];
  double x[capacity], y[capacity]; // x_i - x_j [um]
  double r2[capacity];
  double value[capacity]; // of the kernel
};

/// Calls body for the neighbours within reach of particle i, in list order, up to Near::capacity of them at a time.
template <class Body>
void each_near(const EcmState& ecm, const Adjacency& pairs, double reach, std::size_t i, const Body& body) {
  Near near;
  for (auto row = pairs.of(i); !row.empty(); row = row.subspan(std::min(Near::capacity, row.size()))) {
    near.count = 0;
    for (const std::uint32_t j : row.first(std::min(Near::capacity, row.size()))) {
      const Vec2 x_ij = ecm.separation(i, j);
      const double r2 = x_ij.squaredNorm();
      near.j[near.count] = j;
      near.x[near.count] = x_ij.x();
      near.y[near.count] = x_ij.y();
      near.r2[near.count] = r2;
      near.count += r2 < reach * reach ? 1 : 0;
    }
    body(near);
  }
}

/// Evaluates W at the distances.
MATRIGRATE_SIMD
void evaluate_W(const Kernel& kernel, Near& near) {
  for (std::size_t k = 0; k < near.count; ++k) near.value[k] = kernel.W(std::sqrt(near.r2[k]));
}

/// Evaluates c W_slope at the distances.
MATRIGRATE_SIMD
void evaluate_slopes(const Kernel& kernel, double c, Near& near) {
  for (std::size_t k = 0; k < near.count; ++k) near.value[k] = c * kernel.W_slope(std::sqrt(near.r2[k]));
}

} // namespace

double lattice_density(const EcmParameters& p) {
  const Kernel kernel(p.smoothing_length);
  double sum = 0.0;
  for (const Vec2& X : lattice_patch(p, kernel.support())) sum += kernel.W(X.norm());
  return particle_area(p) * sum;
}

double fluid_pressure(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs, const Kernel& kernel,
                      double rho_lattice, std::size_t i) {
  double sum = kernel.W(0.0);
  each_near(ecm, pairs, kernel.support(), i, [&](Near& near) {
    evaluate_W(kernel, near);
    for (std::size_t k = 0; k < near.count; ++k) sum += near.value[k];
  });
  return fluid_pressure(ecm.f[i], ecm.V0 * sum / rho_lattice, moduli(p).K * ecm.stiffness(i));
}

void find_fluid_pressures(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs,
                          std::vector<double>& pressure) {
  const Kernel kernel(p.smoothing_length);
  const double rho_lattice = lattice_density(p);
  std::vector<std::uint32_t> fluid;
  for (std::uint32_t i = 0; i < ecm.size(); ++i)
    if (ecm.f[i] < 1.0) fluid.push_back(i);
  pressure.resize(ecm.size());
  constexpr std::size_t grain = 32;
  parallel_for(
      fluid.size(),
      [&](std::size_t k) { pressure[fluid[k]] = fluid_pressure(ecm, p, pairs, kernel, rho_lattice, fluid[k]); }, grain);
}

void add_fluid_forces(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs,
                      std::span<const double> pressure, std::span<Vec2> force) {
  const Kernel kernel(p.smoothing_length);
  const double scale = p.thickness * ecm.V0 * ecm.V0;
  for (std::size_t i = 0; i < ecm.size(); ++i) { // those under pressure repel their neighbours
    if (ecm.f[i] >= 1.0 || pressure[i] == 0.0) continue;
    each_near(ecm, pairs, kernel.support(), i, [&](Near& near) {
      evaluate_slopes(kernel, scale * pressure[i], near);
      Vec2 own = force[i];
      for (std::size_t k = 0; k < near.count; ++k) {
        const Vec2 push = near.value[k] * Vec2(near.x[k], near.y[k]);
        own -= push;
        force[near.j[k]] += push;
      }
      force[i] = own;
    });
  }
}

} // namespace matrigrate
