#include "io/layer_picture.hpp"

#include "markup.hpp"
#include "state/initial.hpp"

#include <gtest/gtest.h>

namespace matrigrate::io {
namespace {

State pulled(const Parameters& p) {
  State s;
  s.ecm = disc(p);
  s.cortex = round_cortex(p.cell);
  s.t = 1800.0;
  for (Vec2& x : s.ecm.x) x.x() *= 1.04;
  return s;
}

TEST(LayerPicture, ShowsDisplacementsWithArrowsAndTheCell) {
  Parameters p;
  p.ecm.radius = 40.0;
  const std::string drawing = displacement_picture(pulled(p), p);
  EXPECT_TRUE(parsed(drawing));
  EXPECT_EQ(count(drawing, "displacement [um]"), 1U);
  EXPECT_GE(count(drawing, "30 min"), 1U);
  EXPECT_EQ(count(drawing, "nan"), 0U);
  Parameters q = p;
  State at_rest;
  at_rest.ecm = disc(q);
  EXPECT_EQ(count(displacement_picture(at_rest, q), "nan"), 0U);
}

TEST(LayerPicture, ShowsTheStressOfTheFibres) {
  Parameters p;
  p.ecm.radius = 40.0;
  p.fibres.arrangement = FibreArrangement::isotropic;
  const State s = pulled(p);
  const FibreNetwork network(s.ecm, p.ecm, p.fibres, Reference(s.ecm, p.ecm));
  const std::string drawing = fibre_stress_picture(s, p, network);
  EXPECT_TRUE(parsed(drawing));
  EXPECT_EQ(count(drawing, "von Mises stress [Pa]"), 1U);
}

} // namespace
} // namespace matrigrate::io
