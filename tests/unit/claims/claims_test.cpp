#include "unit/study/studies.hpp"

#include "claims/claims.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

namespace matrigrate::study {
namespace {

/// Made-up results in one read-out.
Evidence evidence(std::string_view readout, const std::vector<std::vector<double>>& samples) {
  std::string numbers = "1";
  for (std::size_t i = 2; i <= samples.size(); ++i) numbers += fmt::format(", {}", i);
  Evidence e;
  e.emplace("s", Ensemble{read("[sweep]\nprotrusion.number = [" + numbers + "]\n"), results_of(readout, samples)});
  return e;
}

const std::vector<std::vector<double>> apart{{1.0, 1.1, 1.2, 1.3}, {2.0, 2.1, 2.2, 2.3}, {2.05, 2.1, 2.2, 2.4}};
constexpr std::string_view f = "f_mat";

Verdict verdict(Judge& judge) { return judge.finding().verdict; }

TEST(Judge, EachCondition) {
  const Evidence e = evidence(f, apart);
  const Group a{"s", 0};
  const Group b{"s", 1};
  const Group c{"s", 2};
  const auto holds = [&](auto condition) {
    Judge judge(e);
    condition(judge);
    return verdict(judge) == Verdict::holds;
  };
  EXPECT_TRUE(holds([&](Judge& j) { j.differs(a, b, f, Sign::up); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.differs(a, b, f, Sign::down); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.differs(b, c, f, Sign::up); }));
  EXPECT_TRUE(holds([&](Judge& j) { j.same(b, c, f); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.same(a, c, f); }));
  EXPECT_TRUE(holds([&](Judge& j) { j.leans(b, c, f, Sign::up); }));
  EXPECT_TRUE(holds([&](Judge& j) { j.not_beyond(b, c, f, Sign::up); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.not_beyond(a, b, f, Sign::up); }));
  EXPECT_TRUE(holds([&](Judge& j) { j.agrees(a, f, 1.2, 12); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.agrees(a, f, 3.0, 12); }));
  EXPECT_TRUE(holds([&](Judge& j) { j.extreme_agrees("s", 3, f, Sign::up, 2.2, 12); }));
  EXPECT_TRUE(holds([&](Judge& j) { j.within(a, f, 1.0, 1.2); }));
  EXPECT_TRUE(holds([&](Judge& j) { j.below(a, f, 1.5); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.below(a, f, 1.2); }));
  EXPECT_TRUE(holds([&](Judge& j) { j.above(a, f, 0.9); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.above(a, f, 1.1); }));
  EXPECT_TRUE(holds([&](Judge& j) { j.ratio_below(a, b, f, 2.0); }));
  EXPECT_TRUE(holds([&](Judge& j) { j.mean_above("s", f, 1.0); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.none_above("s", f, 2.0); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.differs(a, b, f, Sign::up).same(a, b, f); })) << "all must be met";
}

// Three true nulls of which one has p = 0.033, and three of which one has p = 0.0005.
TEST(SecondEdition, CorrectsWhatDoesNotDifferWithinAClaim) {
  const std::vector<double> x{1.0, 1.1, 1.2, 1.3};
  const auto with = [&](double shift) {
    std::vector<double> y = x;
    for (double& value : y) value += shift;
    return y;
  };
  const auto judged_at = [&](double shift) {
    const Evidence e = evidence(f, {x, with(0.01), with(0.02), with(shift)});
    Judge judge(e);
    for (const std::size_t i : {1, 2, 3}) judge.same({"s", 0}, {"s", i}, f);
    return judge.finding();
  };
  EXPECT_EQ(judged_at(0.25).verdict, Verdict::does_not_hold);
  EXPECT_EQ(judged_at(0.25).second, Verdict::holds);
  EXPECT_TRUE(judged_at(0.25).second_unmet.empty());
  EXPECT_EQ(judged_at(0.6).second, Verdict::does_not_hold) << "no direction is stated, so none can come out";
  EXPECT_EQ(judged_at(0.6).second_unmet.size(), 1U);
}

TEST(SecondEdition, TakesAMeanWithinATenthWhateverTheScatter) {
  const Evidence e = evidence(f, {{2.14, 2.15, 2.15, 2.16}});
  const auto judged = [&](double published) { return Judge(e).agrees({"s", 0}, f, published, 12).finding(); };
  EXPECT_EQ(judged(2.34).verdict, Verdict::does_not_hold);
  EXPECT_EQ(judged(2.34).second, Verdict::holds); // 2.15 is 8 % below
  EXPECT_EQ(judged(2.5).second, Verdict::does_not_hold);
}

TEST(SecondEdition, TellsWhatComesOutInDirectionAlone) {
  const Evidence e = evidence(f, apart);
  const Group a{"s", 0};
  const Group b{"s", 1};
  const Group c{"s", 2};
  EXPECT_EQ(Judge(e).differs(b, c, f, Sign::up).finding().second, Verdict::in_direction) << "a significance is missed";
  EXPECT_EQ(Judge(e).differs(b, c, f, Sign::down).finding().second, Verdict::does_not_hold);
  EXPECT_EQ(Judge(e).leans(a, b, f, Sign::up).agrees(b, f, 5.0, 12).finding().second, Verdict::in_direction);
  EXPECT_EQ(Judge(e).leans(b, a, f, Sign::up).agrees(b, f, 5.0, 12).finding().second, Verdict::does_not_hold);
  EXPECT_EQ(Judge(e).below(b, f, 2.2).finding().second, Verdict::in_direction) << "the interval reaches over the bound";
  EXPECT_EQ(Judge(e).finding().second, Verdict::undecided);
  EXPECT_EQ(Judge(evidence(f, {{1.0}, {2.0}})).differs(a, b, f, Sign::up).finding().second, Verdict::undecided);
}

TEST(SecondEdition, AsksOfMostRunsWhatTheTextSaysOfMost) {
  const Evidence e = evidence(f, {{1.0, 2.0, 3.0, 4.0}});
  const auto most = [&](double share) {
    return Judge(e).only_first().none_above("s", f, 3.0).only_second().mostly_up_to("s", f, 3.0, share).finding();
  };
  EXPECT_EQ(most(0.75).verdict, Verdict::does_not_hold);
  EXPECT_EQ(most(0.75).second, Verdict::holds);
  EXPECT_EQ(most(0.8).second, Verdict::does_not_hold);
}

TEST(Judge, CorrelatesReadOutsOverRuns) {
  Evidence e = evidence(f, apart);
  const std::vector<std::string> names = all_readouts();
  const auto column = [&](std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  };
  double sign = 1.0;
  for (Result& r : e.at("s").results) { // falls with f but for noise; and noise alone
    r.readouts[column("tau_prot_min")] = 40.0 - 5.0 * r.readouts[column(f)] + sign;
    r.readouts[column("l_prot_um")] = 28.0 + sign;
    sign = -sign;
  }
  const auto holds = [&](auto condition) {
    Judge judge(e);
    condition(judge);
    return verdict(judge) == Verdict::holds;
  };
  EXPECT_TRUE(holds([&](Judge& j) { j.correlates("s", f, "tau_prot_min", Sign::down); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.correlates("s", f, "tau_prot_min", Sign::up); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.uncorrelated("s", f, "tau_prot_min"); }));
  EXPECT_FALSE(holds([&](Judge& j) { j.correlates("s", f, "l_prot_um", Sign::up); }));
  EXPECT_TRUE(holds([&](Judge& j) { j.uncorrelated("s", f, "l_prot_um"); }));
}

TEST(Judge, PrintsNoNumbersThatAreNone) {
  const Evidence e = evidence(f, {{1.0}, {}});
  Judge judge(e);
  judge.differs({"s", 0}, {"s", 1}, f, Sign::up).correlates("s", f, "l_prot_um", Sign::up).mean_above("s", f, 0.5);
  const Finding finding = judge.finding();
  EXPECT_EQ(finding.verdict, Verdict::undecided);
  for (const auto& lines : {finding.ours, finding.conditions})
    for (const std::string& line : lines) EXPECT_EQ(line.find("nan"), std::string::npos) << line;
}

TEST(Judge, ComparesTwoReadOutsOfTheSameRuns) {
  Evidence e = evidence(f, apart);
  const std::vector<std::string> names = all_readouts();
  const auto force = static_cast<std::size_t>(std::ranges::find(names, "force_nN") - names.begin());
  const auto f_mat = static_cast<std::size_t>(std::ranges::find(names, f) - names.begin());
  double excess = 0.01;
  for (Result& r : e.at("s").results) r.readouts[force] = r.readouts[f_mat] + (excess += 1e-3); // little, but in each
  Judge above(e);
  EXPECT_EQ(verdict(above.exceeds({"s", 0}, f, "force_nN")), Verdict::holds);
  Judge below(e);
  EXPECT_EQ(verdict(below.exceeds({"s", 0}, "force_nN", f)), Verdict::does_not_hold);
  Judge none(e);
  EXPECT_EQ(verdict(none.exceeds({"s", 0}, f, "tau_prot_min")), Verdict::undecided);
}

TEST(Judge, IsUndecidedWithoutRuns) {
  const Evidence e = evidence(f, {{1.0}, {2.0, 3.0}});
  Judge few(e);
  EXPECT_EQ(verdict(few.differs({"s", 0}, {"s", 1}, f, Sign::up)), Verdict::undecided);
  Judge nowhere(e);
  EXPECT_EQ(verdict(nowhere.same({"t", 0}, {"t", 1}, f)), Verdict::undecided);
  Judge nothing(e);
  EXPECT_EQ(verdict(nothing), Verdict::undecided);
}

TEST(Claims, AreComplete) {
  std::set<std::string> ids;
  for (const Claim& claim : all_claims()) {
    ids.emplace(claim.id);
    EXPECT_EQ(claim.judge({}).verdict, Verdict::undecided) << claim.id;
    for (const std::string_view name : claim.studies)
      EXPECT_TRUE(std::filesystem::exists(fmt::format("{}/studies/{}.toml", MATRIGRATE_SOURCE_DIR, name))) << name;
  }
  EXPECT_EQ(ids, (std::set<std::string>{"A1", "A2", "A3", "A4", "A5", "A6", "A7", "A8", "B1", "B2", "B3",
                                        "B4", "C1", "C2", "C3", "C4", "C5", "D1", "D2", "D3", "D4", "E1",
                                        "E2", "E3", "E4", "E5", "X1", "X2", "X3", "X4", "X5"}));
}

TEST(Claims, AreJudgedByTheStudiesThatTheyName) {
  for (const Claim& claim : all_claims()) {
    Evidence e;
    for (const std::string_view name : claim.studies) {
      const Study s = read_study(fmt::format("{}/studies/{}.toml", MATRIGRATE_SOURCE_DIR, name));
      std::vector<Result> results;
      for (std::size_t i = 0; i < s.points.size(); ++i)
        for (std::size_t k = 1; k <= 3; ++k) { // any numbers, so that nothing is undecided
          std::vector<double> values(all_readouts().size());
          for (std::size_t v = 0; v < values.size(); ++v)
            values[v] = static_cast<double>(1 + (i * 7 + k * k * 3 + v * k) % 11);
          Result& r = results.emplace_back();
          r.run.point = i;
          r.readouts = values;
        }
      e.emplace(name, Ensemble{s, results});
    }
    EXPECT_NE(claim.judge(e).verdict, Verdict::undecided) << claim.id;
  }
}

TEST(Claims, AreThirtyWithThePartsAndHaveAKind) {
  std::map<RowKind, int> kinds;
  for (const Claim& claim : claims()) ++kinds[row_kind(claim.id)];
  EXPECT_EQ(kinds[RowKind::calibration], 16);
  EXPECT_EQ(kinds[RowKind::predicted], 10);
  EXPECT_EQ(row_kind("E4"), RowKind::calibration) << "rows E served the choice of the second set";
  EXPECT_EQ(row_kind("E4", ClosureSet::first), RowKind::predicted);
  EXPECT_EQ(kinds[RowKind::verification], 0);
  EXPECT_EQ(row_kind("V2"), RowKind::verification);
  EXPECT_EQ(row_kind("A7"), RowKind::calibration);
  EXPECT_EQ(row_kind("A8"), RowKind::predicted);
  EXPECT_EQ(row_kind("X1"), RowKind::experiment);
}

TEST(Claims, TableSaysWhyNot) {
  const Evidence e = evidence(f, apart);
  const Group a{"s", 0};
  const Group b{"s", 1};
  Judge judge(e);
  judge.differs(a, b, f, Sign::up).same(a, b, f);
  const JudgedClaim no{"A1", "f_mat rises and does not", "1 to 2", judge.finding(), {}};
  const JudgedClaim yes{"B1", "f_mat rises", "", Judge(e).differs(a, b, f, Sign::up).finding(), {}};
  EXPECT_EQ(no.finding.brief, "f_mat 1.15 [0.945, 1.36] (n_prot 1), 2.15 [1.94, 2.36] (n_prot 2)");
  EXPECT_EQ(why_not(no.finding), "not met: f_mat at n_prot 2 not significantly different from that at n_prot 1 "
                                 "(difference 1 [0.777, 1.22], p 3.4e-05)");
  EXPECT_EQ(why_not(yes.finding), "");
  EXPECT_EQ(bottom_line({no, yes}), "1 of 2 hold: 0 of 1 calibration, 1 of 1 predicted");
  const std::string table = markdown_table({no, yes});
  EXPECT_NE(table.find("| A1 | calibration | f_mat rises and does not | 1 to 2 | f_mat 1.15"), std::string::npos)
      << table;
  EXPECT_NE(table.find("| **holds** | holds |  |\n"), std::string::npos) << table;
  EXPECT_NE(table.find("| **does not hold** | in direction | not met"), std::string::npos) << table;
  EXPECT_EQ(second_bottom_line({no, yes}),
            "1 of 2 hold and 1 more are in direction by the second edition of the rules");
}

} // namespace
} // namespace matrigrate::study
