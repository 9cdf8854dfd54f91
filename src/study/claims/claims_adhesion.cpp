#include "claims/claims.hpp"

namespace matrigrate::study {

namespace {

using namespace readout;

/// Points of the three studies: 50, 100, 200, 300, 400 Pa.
Group normal(std::size_t point) { return {"stiffness", point}; }               ///< zeta_diss 2e4
Group sensitive(std::size_t point) { return {"sensitive-adhesions", point}; }  ///< zeta_diss 8e4
Group constant(std::size_t point) { return {"insensitive-adhesions", point}; } ///< r_off whatever the force
constexpr std::size_t stiffnesses = 5;

Finding c1(const Evidence& e) { return Judge(e).differs(normal(0), normal(4), low_share, Sign::up).finding(); }

Finding c2(const Evidence& e) {
  Judge judge(e);
  for (std::size_t i = 0; i < stiffnesses; ++i) judge.leans(normal(i), sensitive(i), low_share, Sign::up);
  for (std::size_t i = 2; i < stiffnesses; ++i)
    judge.differs(normal(i), sensitive(i), n, Sign::down).differs(normal(i), sensitive(i), tau, Sign::up);
  for (std::size_t i = 0; i < stiffnesses; ++i) judge.same(normal(i), sensitive(i), v_abs);
  return judge.finding();
}

Finding c3(const Evidence& e) {
  Judge judge(e);
  for (std::size_t i = 0; i < stiffnesses; ++i)
    judge.same(constant(i), normal(i), v_abs).same(constant(i), sensitive(i), v_abs);
  return judge.finding();
}

Finding c4(const Evidence& e) {
  Judge judge(e);
  for (const std::size_t i : {0, 1}) // 50, 100 Pa
    judge.differs(constant(i), normal(i), n, Sign::down).differs(constant(i), normal(i), tau, Sign::up);
  return judge.differs(constant(3), normal(3), n, Sign::up).differs(constant(3), normal(3), tau, Sign::down).finding();
}

Finding c5(const Evidence& e) {
  Judge judge(e);
  for (const std::size_t i : {0, 1, 2, 4}) judge.differs(constant(i), sensitive(i), n, Sign::down);
  for (const std::size_t i : {0, 1, 2}) judge.differs(constant(i), sensitive(i), tau, Sign::up);
  return judge.finding();
}

} // namespace

std::vector<Claim> adhesion_claims() {
  return {{"C1", {"stiffness"}, "the share of adhesions that end at a low f_adh_rel rises with E", "", c1},
          {"C2",
           {"stiffness", "sensitive-adhesions"},
           "zeta_diss 8e4: a larger share ends at a low f_adh_rel at every E; n_protrusions lower and tau_prot higher "
           "from 200 Pa on; v_migr_abs unchanged",
           "",
           c2},
          {"C3",
           {"stiffness", "sensitive-adhesions", "insensitive-adhesions"},
           "r_off whatever the force: v_migr_abs does not differ from either set at any E",
           "",
           c3},
          {"C4",
           {"stiffness", "insensitive-adhesions"},
           "against it, zeta_diss 2e4 has fewer protrusions and a higher tau_prot at 50 and 100 Pa, the inverse at "
           "300 Pa",
           "",
           c4},
          {"C5",
           {"sensitive-adhesions", "insensitive-adhesions"},
           "against it, zeta_diss 8e4 has fewer protrusions at 50, 100, 200, 400 Pa and a higher tau_prot at 50, 100, "
           "200 Pa",
           "",
           c5}};
}

} // namespace matrigrate::study
