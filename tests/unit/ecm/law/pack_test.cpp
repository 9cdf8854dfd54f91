// Each law gives a pack the bits that it gives each of its numbers.

#include "pack.hpp"

#include "ecm/law/fluid.hpp"
#include "ecm/law/material.hpp"
#include "ecm/law/viscosity.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace matrigrate;

namespace {

constexpr std::size_t lanes = 8;

/// Eight numbers around `middle` that share no pattern.
Eight around(double middle, double width, double phase) {
  Eight a;
  for (std::size_t l = 0; l < lanes; ++l)
    a.set(l, middle + width * std::sin(12.9898 * (static_cast<double>(l) + phase)));
  return a;
}

TensorOf<Eight> tensor(double middle, double width, double phase) {
  return {around(middle, width, phase), around(0.0, width, phase + 0.1), around(0.0, width, phase + 0.2),
          around(middle, width, phase + 0.3)};
}

Tensor lane(const TensorOf<Eight>& A, std::size_t l) { return {A.xx[l], A.xy[l], A.yx[l], A.yy[l]}; }

void expect_same(const TensorOf<Eight>& pack, std::size_t l, const Tensor& number) {
  EXPECT_EQ(pack.xx[l], number.xx);
  EXPECT_EQ(pack.xy[l], number.xy);
  EXPECT_EQ(pack.yx[l], number.yx);
  EXPECT_EQ(pack.yy[l], number.yy);
}

const Eight rho = around(1.0, 0.2, 0.0);
const TensorOf<Eight> S = tensor(0.0, 0.03, 0.4);
const TensorOf<Eight> F = tensor(1.0, 0.2, 0.8);
const TensorOf<Eight> L = tensor(0.0, 0.5, 1.2);

} // namespace

TEST(PackOfMaterial, HasTheBitsOfEachNumber) {
  const double K = 0.7, G = 0.07, dt = 0.4;
  const auto rate = jaumann_rate(S, L, G);
  const auto sigma = cauchy_stress(rho, S, K);
  const auto P = piola_kirchhoff(sigma, F);
  const auto gradient = velocity_gradient(L, F);
  const auto after = advanced({rho, S}, L, G, dt, 0.95, 1.1);
  for (std::size_t l = 0; l < lanes; ++l) {
    EXPECT_EQ(pressure(rho, K)[l], pressure(rho[l], K));
    EXPECT_EQ(density_rate(rho, L)[l], density_rate(rho[l], lane(L, l)));
    expect_same(rate, l, jaumann_rate(lane(S, l), lane(L, l), G));
    expect_same(sigma, l, cauchy_stress(rho[l], lane(S, l), K));
    expect_same(P, l, piola_kirchhoff(lane(sigma, l), lane(F, l)));
    expect_same(gradient, l, velocity_gradient(lane(L, l), lane(F, l)));
    const SolidStateOf<double> number = advanced({rho[l], lane(S, l)}, lane(L, l), G, dt, 0.95, 1.1);
    EXPECT_EQ(after.rho[l], number.rho);
    expect_same(after.S, l, number.S);
  }
}

TEST(PackOfFluid, HasTheBitsOfEachNumber) {
  const Eight f = around(0.5, 0.5, 0.7);
  const Eight p = fluid_pressure(f, rho, 0.7);
  for (std::size_t l = 0; l < lanes; ++l) EXPECT_EQ(p[l], fluid_pressure(f[l], rho[l], 0.7));
}

TEST(PackOfDrag, HasTheBitsOfEachNumber) {
  const EcmParameters p;
  const Kernel kernel(p.smoothing_length);
  const PairDrag<Eight> of_pack(p, kernel, 4.0);
  const PairDrag<double> of_number(p, kernel, 4.0);
  const Eight r = around(3.0, 3.0, 0.0); // some beyond the support of 5.2 um
  const Eight G = of_pack(r, r * r);
  for (std::size_t l = 0; l < lanes; ++l) EXPECT_EQ(G[l], of_number(r[l], r[l] * r[l]));
}
