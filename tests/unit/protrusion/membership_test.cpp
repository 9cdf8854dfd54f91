#include "protrusion/membership.hpp"

#include "scene.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

TEST(Membership, OfACellWithoutProtrusionsIsAllBody) {
  const Parameters p = small_matrix();
  const Membership m = membership(round_cell(p), p);
  EXPECT_TRUE(std::ranges::all_of(m.of_particle, [](int n) { return n == no_protrusion; }));
  EXPECT_TRUE(std::ranges::all_of(m.f_mat, [](double f) { return f == 0.05; }));
  EXPECT_TRUE(std::ranges::all_of(m.k_s, [](double k) { return k == 2.8; }));
  EXPECT_EQ(std::ranges::count(m.on_protrusion, 1), 0);
  EXPECT_EQ(std::ranges::count(m.soft, 1), 0);
}

TEST(Membership, SpansTwentyParticlesToEachSideAcrossTheSeam) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 5, Growing{outward(s, 5)});
  const Membership m = membership(s.cell, p);
  EXPECT_EQ(std::ranges::count(m.of_particle, 0), 41);
  EXPECT_EQ(m.of_particle[25], 0);
  EXPECT_EQ(m.of_particle[26], no_protrusion);
  EXPECT_EQ(m.of_particle[220], 0); // 235 - 15
  EXPECT_EQ(m.of_particle[219], no_protrusion);
  EXPECT_EQ(std::ranges::count(m.on_protrusion, 1), 40);
  EXPECT_EQ(m.on_protrusion[25], 0); // its second end is body
}

TEST(Membership, SaysWhatEachPhaseMakesOfTheCortex) {
  const Parameters p = small_matrix();
  struct Row {
    Phase phase;
    double f_mat, k_s;
    int soft;
  };
  const Vec2 d(1.0, 0.0);
  for (const Row& row : {Row{Growing{d}, 0.0, 2.8e-3, 1}, Row{Maturing{d, d, 3}, 0.0, 2.8e-3, 1},
                         Row{Contracting{d, 0.7}, 0.7, 2.8, 0}, Row{Finishing{0.6}, 0.6, 2.8, 0}}) {
    Scene s = cell_in_matrix(p);
    add_protrusion(s, 100, row.phase);
    const Membership m = membership(s.cell, p);
    for (std::size_t i = 80; i <= 120; ++i) EXPECT_EQ(m.f_mat[i], row.f_mat) << name(row.phase);
    for (std::size_t i = 80; i < 120; ++i) {
      EXPECT_EQ(m.k_s[i], row.k_s) << name(row.phase);
      EXPECT_EQ(m.soft[i], row.soft) << name(row.phase);
    }
    EXPECT_EQ(m.f_mat[79], 0.05);
    EXPECT_EQ(m.k_s[120], 2.8);
  }
}
