#include "claims/claims.hpp"

namespace matrigrate::study {

namespace {

using namespace readout;

/// Points of studies/stiffness.toml: 50, 100, 200, 300, 400 Pa; of contraction.toml: 0.4, 0.8, 1.2, 1.6, 2 nN in both
/// strands.
Group E(std::size_t point) { return {"stiffness", point}; }
Group F(std::size_t point) { return {"contraction", point}; }

Finding a1(const Evidence& e) {
  return Judge(e)
      .extreme_agrees("stiffness", 5, v_abs, Sign::down, 3.7, 12)
      .extreme_agrees("stiffness", 5, v_abs, Sign::up, 10.2, 12)
      .finding();
}

Finding a2(const Evidence& e) {
  return Judge(e)
      .differs(E(0), E(2), v_abs, Sign::up)
      .same(E(2), E(3), v_abs)
      .same(E(3), E(4), v_abs)
      .same(E(2), E(4), v_abs)
      .finding();
}

Finding a3(const Evidence& e) {
  Judge judge(e);
  judge.differs(E(0), E(2), n, Sign::up).differs(E(0), E(2), tau, Sign::down);
  for (const std::string_view readout : {n, tau})
    judge.same(E(2), E(3), readout).same(E(3), E(4), readout).same(E(2), E(4), readout);
  return judge.finding();
}

Finding a4(const Evidence& e) {
  Judge judge(e);
  judge.leans(E(0), E(4), length, Sign::down);
  for (std::size_t i = 0; i < 5; ++i) judge.within(E(i), length, 25.0, 30.0);
  return judge.finding();
}

Finding a5(const Evidence& e) { return Judge(e).differs(E(2), E(4), f_mat, Sign::up).finding(); }

Finding a6(const Evidence& e) {
  return Judge(e)
      .correlates("stiffness", v_abs, n, Sign::up)
      .correlates("stiffness", v_abs, tau, Sign::down)
      .correlates("stiffness", v_abs, length, Sign::down)
      .finding();
}

Finding a7(const Evidence& e) {
  return Judge(e)
      .mean_above("stiffness", "share_2_or_3_protrusions", 0.5)
      .only_first()
      .none_above("stiffness", "n_simultaneous_max", 3.0)
      .only_second() // the Discussion: "in most simulations"
      .mostly_up_to("stiffness", "n_simultaneous_max", 3.0, 0.5)
      .finding();
}

Finding a8(const Evidence& e) {
  Judge judge(e);
  judge.differs(F(0), F(2), v_abs, Sign::up).differs(F(0), F(2), n, Sign::up).differs(F(0), F(2), tau, Sign::down);
  for (const std::string_view readout : {v_abs, n, tau}) judge.same(F(3), F(4), readout);
  return judge.finding();
}

/// Points of studies/initiation-rate.toml: 1e-5 to 1e-4 /s; of disassembly-rate.toml: 1/90 to 1/10 min; of
/// growth-time.toml: 200 to 600 s.
Group r(std::size_t point) { return {"initiation-rate", point}; }
Group off(std::size_t point) { return {"disassembly-rate", point}; }
Group T(std::size_t point) { return {"growth-time", point}; }

Finding b1(const Evidence& e) {
  return Judge(e)
      .extreme_agrees("initiation-rate", 5, n, Sign::down, 8.0, 12)
      .extreme_agrees("initiation-rate", 5, n, Sign::up, 15.0, 12)
      .differs(r(0), r(4), n, Sign::up)
      .same(r(0), r(4), v_abs)
      .uncorrelated("initiation-rate", v_abs, n)
      .finding();
}

Finding b2(const Evidence& e) { return Judge(e).not_beyond(r(0), r(4), tau, Sign::down).finding(); }

Finding b3(const Evidence& e) {
  return Judge(e)
      .differs(off(0), off(4), tau, Sign::down)
      .differs(off(0), off(4), n, Sign::up)
      .same(off(0), off(4), v_abs)
      .finding();
}

Finding b4(const Evidence& e) {
  return Judge(e)
      .differs(T(0), T(4), length, Sign::up)
      .ratio_below(T(0), T(4), length, 3.0)
      .same(T(0), T(4), v_abs)
      .leans(T(0), T(4), n, Sign::down)
      .leans(T(0), T(4), tau, Sign::up)
      .finding();
}

} // namespace

std::vector<Claim> migration_claims() {
  return {{"A1", {"stiffness"}, "mean v_migr_abs over the five stiffnesses", "3.7 to 10.2 um/h", a1},
          {"A2", {"stiffness"}, "v_migr_abs rises over 50-200 Pa; 200, 300, 400 Pa do not differ", "", a2},
          {"A3", {"stiffness"}, "n_protrusions rises, tau_prot falls over 50-200 Pa; no change 200-400 Pa", "", a3},
          {"A4", {"stiffness"}, "l_prot slightly lower with stiffness; 25-30 um at T_prot = 400 s", "25 to 30 um", a4},
          {"A5", {"stiffness"}, "f_mat still rises from 200 to 400 Pa", "", a5},
          {"A6", {"stiffness"}, "v_migr_abs goes with n_protrusions (+), tau_prot (-), l_prot (-)", "", a6},
          {"A7", {"stiffness"}, "usually 2 or 3 protrusions at a time, not more than 3", "2 or 3; at most 3", a7},
          {"A8",
           {"contraction"},
           "v_migr_abs and n_protrusions rise, tau_prot falls at low F_am; flat at high F_am",
           "",
           a8}};
}

std::vector<Claim> rate_claims() {
  return {{"B1",
           {"initiation-rate"},
           "n_protrusions runs from 8 to 15 with r_prot; v_migr_abs unaffected; the two do not correlate",
           "8 to 15",
           b1},
          {"B2", {"initiation-rate"}, "tau_prot unaffected by r_prot or slightly higher", "", b2},
          {"B3",
           {"disassembly-rate"},
           "tau_prot falls and n_protrusions rises with r_off_min; v_migr_abs unaffected",
           "",
           b3},
          {"B4",
           {"growth-time"},
           "l_prot rises with T_prot, less than proportionally; v_migr_abs unaffected; n_protrusions slightly lower, "
           "tau_prot slightly higher",
           "",
           b4}};
}

} // namespace matrigrate::study
