#include "claims/claims.hpp"

namespace matrigrate::study {

namespace {

using namespace readout;

/// Kept numbers of protrusions, from 1 to 4.
Group plain(std::size_t number) { return {"kept-protrusions", number - 1}; }
Group fibres(std::size_t number) { return {"kept-protrusions-fibres", number - 1}; }
constexpr double runs_plain = 17;
constexpr double runs_fibres = 18; // the paper has 17 to 19
constexpr double near = 0.25;

Finding d1(const Evidence& e) {
  return Judge(e)
      .differs(plain(1), plain(4), v_abs, Sign::down)
      .agrees(plain(1), v_abs, 12.1, runs_plain)
      .agrees(plain(4), v_abs, 3.7, runs_plain)
      .finding();
}

Finding d2(const Evidence& e) {
  Judge judge(e);
  for (const std::size_t number : {1, 2, 4}) judge.leans(plain(number), plain(3), v_path, Sign::up);
  return judge.agrees(plain(3), v_path, 26.6, runs_plain)
      .agrees(plain(1), v_path, 22.0, runs_plain)
      .agrees(plain(4), v_path, 22.0, runs_plain)
      .finding();
}

Finding d3(const Evidence& e) {
  return Judge(e).differs(plain(1), plain(4), n, Sign::up).agrees(plain(1), n, 9.9, runs_plain).finding();
}

Finding d4(const Evidence& e) {
  Judge judge(e);
  judge.within(plain(4), slope, 1.0 - near, 1.0 + near);
  for (const std::size_t number : {1, 2, 3}) judge.leans(plain(number + 1), plain(number), slope, Sign::up);
  return judge.finding();
}

Finding e1(const Evidence& e) {
  Judge judge(e);
  for (const std::size_t number : {1, 3, 4}) judge.leans(fibres(number), fibres(2), v_abs, Sign::up);
  return judge.agrees(fibres(2), v_abs, 10.7, runs_fibres)
      .same(fibres(2), fibres(1), v_abs)
      .differs(fibres(2), fibres(3), v_abs, Sign::down)
      .differs(fibres(2), fibres(4), v_abs, Sign::down)
      .finding();
}

Finding e2(const Evidence& e) {
  Judge judge(e);
  for (const std::size_t number : {2, 3, 4}) judge.leans(fibres(1), fibres(number), v_path, Sign::up);
  for (const std::size_t number : {3, 4}) judge.leans(fibres(number), fibres(2), v_path, Sign::up);
  return judge.agrees(fibres(1), v_path, 14.6, runs_fibres).agrees(fibres(2), v_path, 21.2, runs_fibres).finding();
}

Finding e3(const Evidence& e) {
  return Judge(e).differs(plain(1), fibres(1), n, Sign::down).agrees(fibres(1), n, 5.6, runs_fibres).finding();
}

Finding e4(const Evidence& e) {
  Judge judge(e);
  for (std::size_t number = 1; number <= 4; ++number)
    judge.below(fibres(number), angle, random_angle_deg).leans(plain(number), fibres(number), slope, Sign::up);
  return judge.finding();
}

Finding e5(const Evidence& e) {
  return Judge(e)
      .exceeds(fibres(2), ruptured_along, ruptured_across)
      .exceeds(fibres(2), f_mat_across, f_mat_along)
      .finding();
}

} // namespace

std::vector<Claim> kept_claims() {
  const std::vector<std::string_view> both{"kept-protrusions", "kept-protrusions-fibres"};
  return {{"D1",
           {"kept-protrusions"},
           "v_migr_abs falls with the number of protrusions",
           "12.1 um/h at 1, 3.7 um/h at 4",
           d1},
          {"D2", {"kept-protrusions"}, "v_migr_path highest at 3", "26.6 um/h at 3, about 22 um/h at 1 and at 4", d2},
          {"D3", {"kept-protrusions"}, "n_protrusions rises with the number kept up", "9.9 at 1", d3},
          {"D4", {"kept-protrusions"}, "slope of the MSD near 1 at 4, steeper with fewer", "about 1 at 4", d4},
          {"E1",
           {"kept-protrusions-fibres"},
           "among fibres v_migr_abs highest at 2; 1 not significantly different, 3 and 4 lower than 2",
           "10.7 um/h at 2",
           e1},
          {"E2",
           {"kept-protrusions-fibres"},
           "among fibres v_migr_path lowest at 1, highest at 2",
           "14.6 um/h at 1, 21.2 um/h at 2",
           e2},
          {"E3", both, "n_protrusions at 1 drops among fibres", "5.6, from 9.9", e3},
          {"E4", both, "paths run along the fibres; slopes of the MSD steeper than without", "", e4},
          {"E5",
           {"kept-protrusions-fibres"},
           "among fibres, at 2, protrusions across them stay weak and are ruptured",
           "one run (Fig 13)",
           e5}};
}

std::span<const Claim> claims() {
  static const std::vector<Claim> all = [] {
    std::vector<Claim> joined;
    for (const auto& part : {migration_claims(), rate_claims(), adhesion_claims(), kept_claims()})
      joined.insert(joined.end(), part.begin(), part.end());
    return joined;
  }();
  return all;
}

JudgedClaim judged(const Claim& claim, const Evidence& evidence) {
  return {std::string(claim.id), std::string(claim.sentence), std::string(claim.published), claim.judge(evidence), {}};
}

} // namespace matrigrate::study
