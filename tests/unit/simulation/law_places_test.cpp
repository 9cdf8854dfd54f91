#include "simulation/law_places.hpp"

#include "../protrusion/scene.hpp"
#include "parameters/read.hpp"
#include "protrusion/growth.hpp"

#include <gtest/gtest.h>

namespace matrigrate {
namespace {

Parameters with_contraction(const std::string& law) {
  return apply_overrides(small_matrix(), std::vector{"laws.contraction=" + law});
}

std::vector<LawPlace> places(const Scene& s, const Parameters& p) {
  const Laws laws(p);
  return places_of_forces(s.cell, s.ecm, p, s.now.t, laws);
}

TEST(LawPlaces, AreNotComputedWhereNoLawUsesAny) {
  const Parameters p = small_matrix();
  EXPECT_TRUE(places(cell_in_matrix(p), p).empty());
  const Parameters by_rate =
      apply_overrides(p, std::vector<std::string>{"laws.disassembly_rate=r_off_min*stiffness/E"});
  EXPECT_TRUE(places(cell_in_matrix(by_rate), by_rate).empty()) << "the forces do not use them";
  EXPECT_FALSE(places_of_transitions(round_cell(by_rate), disc(by_rate), by_rate, 0.0, Laws(by_rate)).empty());
}

TEST(LawPlaces, TellPlaceTimeAndProtrusion) {
  const Parameters p = with_contraction("F_am*f_mat*(age + t_mat + l/1)*0");
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 50, Contracting{2.0 * s.cell.cortex.x[50], 0.7}).record.t_mature = 100.0;
  add_protrusion(s, 150, Maturing{.direction = outward(s, 150), .anchor = 2.0 * s.cell.cortex.x[150], .steps = 2});
  s.now.t = 150.0;
  const std::vector<LawPlace> found = places(s, p);
  ASSERT_EQ(found.size(), s.cell.cortex.size());
  for (const std::size_t i : {40U, 50U, 60U}) {
    EXPECT_EQ(found[i].x, s.cell.cortex.x[i].x());
    EXPECT_EQ(found[i].y, s.cell.cortex.x[i].y());
    EXPECT_EQ(found[i].time, 150.0);
    EXPECT_EQ(found[i].age, 150.0);
    EXPECT_EQ(found[i].t_mat, 50.0);
    EXPECT_EQ(found[i].f_mat, 0.7);
    EXPECT_EQ(found[i].l, protrusion_length(s.cell.cortex, 50, p.protrusion));
  }
  EXPECT_DOUBLE_EQ(found[150].f_mat, 0.3);
  EXPECT_EQ(found[150].t_mat, 0.0);
  EXPECT_EQ(found[100].f_mat, p.actomyosin.f_mat_body);
  EXPECT_EQ(found[100].l, 0.0);
  EXPECT_EQ(found[100].age, 0.0);
  EXPECT_EQ(found[100].stiffness, 0.0) << "no law uses the matrix";
}

TEST(LawPlaces, TellTheMatrixAround) {
  const Parameters p = with_contraction("F_am*f_mat*stiffness/E*density*f_degr");
  Scene s = cell_in_matrix(p);
  for (std::size_t k = 0; k < s.ecm.size(); ++k) s.ecm.rho[k] = 1.1;
  s.ecm.E_ratio.assign(s.ecm.size(), 0.5);
  const double K = p.ecm.youngs_modulus / (3.0 * (1.0 - 2.0 * p.ecm.poissons_ratio));
  for (const LawPlace& place : places(s, p)) {
    EXPECT_NEAR(place.density, 1.1, 1e-12);
    EXPECT_NEAR(place.stiffness, 100.0, 1e-9);
    EXPECT_NEAR(place.pressure, 1000.0 * 0.5 * K * 0.1, 1e-9);
    EXPECT_GT(place.f_degr, 0.0) << "beside the hole of the cell";
    EXPECT_LT(place.f_degr, 0.9);
  }
  s.ecm.f.assign(s.ecm.size(), 0.0);
  for (const LawPlace& place : places(s, p))
    EXPECT_EQ(place.density + place.f_degr + place.stiffness, 1.0) << "no solid";
}

TEST(LawPlaces, OfTheCentreAreMeansAlongTheCortex) {
  Parameters p = small_matrix();
  p.laws.polarization_rate = "r_pol*stiffness/E*(x > 0)";
  const Scene s = cell_in_matrix(p);
  const LawPlace at = place_of_centre(s.cell, Vec2(1.0, 2.0), s.ecm, p, 60.0, Law("laws.polarization_rate", p));
  EXPECT_EQ(at.x + at.y + at.time, 63.0);
  EXPECT_NEAR(at.stiffness, 200.0, 1e-9);
}

} // namespace
} // namespace matrigrate
