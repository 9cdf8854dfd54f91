#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/claims.hpp"
#include "unit/study_plan/studies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

namespace matrigrate::study {
namespace {

std::string sweep(std::size_t points) {
  std::string numbers = "1";
  for (std::size_t i = 2; i <= points; ++i) numbers += fmt::format(", {}", i);
  return "[sweep]\nprotrusion.number = [" + numbers + "]\n";
}

/// Made-up results in one read-out of a study "s" with the points "n_prot 1", "n_prot 2", ...
Evidence evidence(std::string_view readout, const std::vector<std::vector<double>>& samples) {
  Evidence e;
  e.emplace("s", Ensemble{read(sweep(samples.size())), results_of(readout, samples)});
  return e;
}

/// What becomes of a claim of these conditions, as they stand in the file of "s".
Finding finding(const Evidence& e, const std::string& conditions) {
  const auto known = e.find("s");
  Claim claim = read(sweep(known == e.end() ? 3 : known->second.study.points.size())
                     + "[[claims]]\nid = \"A1\"\nkind = \"predicted\"\nsentence = \"so it is\"\nconditions = ["
                     + conditions + "]\n")
                    .claims.front();
  claim.study = "s";
  return judged(claim, e);
}

/// A condition of f_mat.
std::string on(std::string_view rule, const std::string& more) {
  return fmt::format("{{ rule = \"{}\", readout = \"f_mat\"{}{} }}, ", rule, more.empty() ? "" : ", ", more);
}
std::string between(std::string_view rule, int a, int b, const std::string& more = {}) {
  return on(rule, fmt::format("from = \"n_prot {}\", to = \"n_prot {}\"{}", a, b, more));
}
const std::string up = ", sign = \"up\"";
const std::string down = ", sign = \"down\"";
std::string at(std::string_view rule, int a, const std::string& more) {
  return on(rule, fmt::format("at = \"n_prot {}\", {}", a, more));
}

const std::vector<std::vector<double>> apart{{1.0, 1.1, 1.2, 1.3}, {2.0, 2.1, 2.2, 2.3}, {2.05, 2.1, 2.2, 2.4}};
constexpr std::string_view f = "f_mat";

/// A curve of mean square displacements that grows with a power of the lag.
std::vector<MsdPoint> power_law(double factor, double slope) {
  std::vector<MsdPoint> points;
  for (const double lag : {600.0, 1200.0, 1800.0, 2400.0})
    points.push_back({.lag = lag, .msd = factor * std::pow(lag, slope), .samples = 1});
  return points;
}

TEST(Judge, ComparesSlopesOfMeanCurves) {
  Evidence e = evidence(f, {{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}});
  e.at("s").msd = {power_law(1, 1.0), power_law(2, 1.0), {}, power_law(1, 1.5), power_law(3, 1.5), power_law(2, 1.5)};
  const auto leans = [&](int from, int to, const std::string& sign) {
    return finding(
        e, fmt::format("{{ rule = \"msd_leans\", from = \"n_prot {}\", to = \"n_prot {}\"{} }}", from, to, sign));
  };
  EXPECT_EQ(leans(1, 2, up).verdict, Verdict::holds);
  EXPECT_EQ(leans(2, 1, up).verdict, Verdict::does_not_hold);
  EXPECT_EQ(leans(2, 1, up).against.size(), 1U);
  EXPECT_EQ(leans(2, 1, down).verdict, Verdict::holds);
  EXPECT_TRUE(leans(1, 2, up).brief.find("1 [1, 1] (n_prot 1), 1.5 [1.5, 1.5] (n_prot 2)") != std::string::npos)
      << leans(1, 2, up).brief;
  e.at("s").msd[1].clear();
  EXPECT_EQ(leans(1, 2, up).verdict, Verdict::undecided); // one run is left
}

TEST(Judge, SlopeOfTheMeanCurveIsNotTheMeanOfSlopes) {
  const MsdCurves runs{power_law(1.0, 1.0), power_law(1e-6, 2.0)};
  EXPECT_LT(msd_slope(mean_curve(runs)), 1.1);
  EXPECT_EQ(mean_curve({power_law(1, 1), {}}).size(), 0U);
  EXPECT_TRUE(mean_curve({}).empty());
}

TEST(Judge, JudgesByAnEditionOfTheRules) {
  const Evidence e = evidence(f, apart);
  const std::string text = sweep(3)
                           + "[[claims]]\nid = \"A1\"\nkind = \"predicted\"\nsentence = \"so it is\"\nconditions = ["
                           + between("leans", 1, 2, up) + between("differs", 1, 2, down + ", of_edition = 2")
                           + between("differs", 1, 2, up + ", of_edition = 3") + "]\n";
  Claim claim = read(text).claims.front();
  claim.study = "s";
  EXPECT_EQ(judged(claim, e).verdict, Verdict::holds);
  EXPECT_EQ(judged(claim, e).conditions.size(), 2U);
  const JudgedClaim row = judged_claim(claim, e);
  ASSERT_TRUE(row.second_edition);
  EXPECT_EQ(row.second_edition->verdict, Verdict::does_not_hold);
  EXPECT_EQ(row.second_edition->against.size(), 1U);
  const std::string table = claims_csv({row});
  EXPECT_TRUE(table.substr(0, table.find('\n'))
                  .ends_with(",caveat,verdict_second_edition,why_not_second_edition,against_second_edition"))
      << table;
  std::erase_if(claim.conditions, [](const ClaimCondition& c) { return c.edition.has_value(); });
  EXPECT_FALSE(judged_claim(claim, e).second_edition);
}

TEST(Judge, EachCondition) {
  const Evidence e = evidence(f, apart);
  const auto holds = [&](const std::string& conditions) { return finding(e, conditions).verdict == Verdict::holds; };
  EXPECT_TRUE(holds(between("differs", 1, 2, up)));
  EXPECT_FALSE(holds(between("differs", 1, 2, down)));
  EXPECT_FALSE(holds(between("differs", 2, 3, up)));
  EXPECT_TRUE(holds(between("same", 2, 3)));
  EXPECT_FALSE(holds(between("same", 1, 3)));
  EXPECT_TRUE(holds(between("leans", 2, 3, up)));
  EXPECT_FALSE(holds(between("leans", 2, 3, down)));
  EXPECT_TRUE(holds(between("not_beyond", 2, 3, up)));
  EXPECT_FALSE(holds(between("not_beyond", 1, 2, up)));
  EXPECT_TRUE(holds(between("not_beyond", 1, 2, down)));
  EXPECT_TRUE(holds(at("agrees", 1, "value = 1.2, runs = 12")));
  EXPECT_FALSE(holds(at("agrees", 1, "value = 3, runs = 12")));
  EXPECT_TRUE(holds(on("highest_agrees", "value = 2.2, runs = 12")));
  EXPECT_FALSE(holds(on("lowest_agrees", "value = 2.2, runs = 12")));
  EXPECT_TRUE(holds(on("lowest_agrees", "value = 1.15, runs = 12")));
  EXPECT_TRUE(holds(at("within", 1, "low = 1, high = 1.2")));
  EXPECT_FALSE(holds(at("within", 2, "low = 1, high = 1.2")));
  EXPECT_TRUE(holds(at("below", 1, "bound = 1.5")));
  EXPECT_FALSE(holds(at("below", 1, "bound = 1.2")));
  EXPECT_TRUE(holds(at("above", 1, "bound = 0.9")));
  EXPECT_FALSE(holds(at("above", 1, "bound = 1.1")));
  EXPECT_TRUE(holds(between("ratio_below", 1, 2, ", bound = 2")));
  EXPECT_FALSE(holds(between("ratio_below", 1, 2, ", bound = 1.8")));
  EXPECT_TRUE(holds(on("mean_above", "bound = 1")));
  EXPECT_FALSE(holds(on("none_above", "bound = 2")));
  EXPECT_FALSE(holds(between("differs", 1, 2, up) + between("same", 1, 2))) << "all must be met";
}

// Two runs a point scatter so much that no test finds a difference.
TEST(Judge, DoesNotTakeTooFewRunsForAgreement) {
  const Evidence few = evidence(f, {{1.0, 9.0}, {2.0, 12.0}, {3.0, 4.0}});
  for (const std::string& condition :
       {between("same", 1, 2), between("not_beyond", 1, 2, up), between("not_beyond", 1, 2, down),
        at("agrees", 1, "value = 5, runs = 12"), on("highest_agrees", "value = 7, runs = 12")}) {
    const Finding found = finding(few, condition);
    EXPECT_EQ(found.verdict, Verdict::undecided) << condition;
    EXPECT_EQ(found.unmet, std::vector<std::string>{"too few runs"});
  }
  EXPECT_NE(finding(few, between("same", 1, 2)).conditions.at(0).find("too few runs to tell"), std::string::npos);
  EXPECT_EQ(finding(few, between("leans", 1, 2, up)).verdict, Verdict::holds) << "no test is asked for";
  EXPECT_EQ(finding(few, between("same", 1, 2) + between("leans", 1, 2, down)).verdict, Verdict::does_not_hold)
      << "one condition fails whatever the other says";
  const Evidence below = evidence(f, {{8.0, 10.0, 9.0, 9.5}, {1.0, 3.0, 0.1, 2.0}});
  EXPECT_EQ(finding(below, between("not_beyond", 1, 2, up)).verdict, Verdict::holds) << "wholly on the other side";
}

TEST(Judge, TakesAnIntervalOfHalfTheMeanForEnough) {
  const auto verdict = [](double half) { // of the interval of the mean 10: t is 12.706 for two runs
    const double off = half / 12.7062;
    return finding(evidence(f, {{10.0 - off, 10.0 + off}}), at("agrees", 1, "value = 10, runs = 12")).verdict;
  };
  EXPECT_EQ(verdict(4.99), Verdict::holds);
  EXPECT_EQ(verdict(5.01), Verdict::undecided);
}

// Three true nulls of which one has p = 0.033, and three of which one has p = 0.0005.
TEST(Judge, CorrectsWhatDoesNotDifferWithinAClaim) {
  const std::vector<double> x{1.0, 1.1, 1.2, 1.3};
  const auto with = [&](double shift) {
    std::vector<double> y = x;
    for (double& value : y) value += shift;
    return y;
  };
  const auto judged_at = [&](double shift) {
    return finding(evidence(f, {x, with(0.01), with(0.02), with(shift)}),
                   between("same", 1, 2) + between("same", 1, 3) + between("same", 1, 4));
  };
  const Finding corrected = judged_at(0.25);
  EXPECT_EQ(corrected.verdict, Verdict::holds);
  EXPECT_TRUE(corrected.unmet.empty());
  EXPECT_TRUE(corrected.conditions.at(2).ends_with("], p 0.034, corrected 0.1): met")) << corrected.conditions.at(2);
  EXPECT_EQ(judged_at(0.6).verdict, Verdict::does_not_hold) << "no direction is stated, so none can come out";
  EXPECT_EQ(judged_at(0.6).unmet.size(), 1U);
}

TEST(Judge, TakesAMeanWithinATenthWhateverTheScatter) {
  const Evidence e = evidence(f, {{2.14, 2.15, 2.15, 2.16}});
  const auto judged = [&](double published) {
    return finding(e, at("agrees", 1, fmt::format("value = {}, runs = 12", published)));
  };
  EXPECT_EQ(judged(2.34).verdict, Verdict::holds); // 2.15 is 8 % below
  EXPECT_TRUE(judged(2.34).conditions.at(0).ends_with(", within a tenth): met")) << judged(2.34).conditions.at(0);
  EXPECT_EQ(judged(2.5).verdict, Verdict::does_not_hold);
}

TEST(Judge, TellsWhatComesOutInDirectionAlone) {
  const Evidence e = evidence(f, apart);
  const auto verdict = [&](const std::string& conditions) { return finding(e, conditions).verdict; };
  const std::string far = at("agrees", 2, "value = 5, runs = 12");
  EXPECT_EQ(verdict(between("differs", 2, 3, up)), Verdict::in_direction) << "a significance is missed";
  EXPECT_EQ(verdict(between("differs", 2, 3, down)), Verdict::does_not_hold);
  EXPECT_EQ(verdict(between("leans", 1, 2, up) + far), Verdict::in_direction);
  EXPECT_EQ(verdict(between("leans", 2, 1, up) + far), Verdict::does_not_hold);
  EXPECT_EQ(verdict(at("below", 2, "bound = 2.2")), Verdict::in_direction) << "the interval reaches over the bound";
  EXPECT_EQ(judged({.id = "A1", .study = "s"}, e).verdict, Verdict::undecided);
  EXPECT_EQ(finding(evidence(f, {{1.0}, {2.0}}), between("differs", 1, 2, up)).verdict, Verdict::undecided);
}

TEST(Judge, NamesWhatComesOutOppositeByAWholeInterval) {
  const Evidence e = evidence(f, apart);
  const auto against = [&](const std::string& conditions) { return finding(e, conditions).against.size(); };
  for (const char* rule : {"differs", "leans"}) {
    EXPECT_EQ(against(between(rule, 1, 2, down)), 1U) << rule;
    EXPECT_EQ(against(between(rule, 1, 2, up)), 0U) << rule;
    EXPECT_EQ(against(between(rule, 2, 3, down)), 0U) << rule << ": the interval contains 0";
  }
  EXPECT_EQ(against(between("not_beyond", 1, 2, up)), 0U) << "no direction is stated";
  EXPECT_EQ(against(at("below", 2, "bound = 1")), 1U);
  EXPECT_EQ(against(at("below", 2, "bound = 2.2")), 0U);
  EXPECT_EQ(against(at("above", 2, "bound = 9")), 1U);
}

TEST(Judge, AsksOfMostRunsWhatTheTextSaysOfMost) {
  const Evidence e = evidence(f, {{1.0, 2.0, 3.0, 4.0}});
  const auto most = [&](double share) {
    return finding(e, on("mostly_up_to", fmt::format("bound = 3, share = {}", share)));
  };
  EXPECT_EQ(most(0.75).verdict, Verdict::holds);
  EXPECT_EQ(most(0.75).brief, "maturation of protrusions, mean: at most 3 in 75 % (n = 4)");
  EXPECT_EQ(most(0.8).verdict, Verdict::does_not_hold);
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
  const auto holds = [&](const std::string& conditions) { return finding(e, conditions).verdict == Verdict::holds; };
  EXPECT_TRUE(holds(on("correlates", "with = \"tau_prot_min\"" + down)));
  EXPECT_FALSE(holds(on("correlates", "with = \"tau_prot_min\"" + up)));
  EXPECT_FALSE(holds(on("uncorrelated", "with = \"tau_prot_min\"")));
  EXPECT_FALSE(holds(on("correlates", "with = \"l_prot_um\"" + up)));
  const std::string uncorrelated = on("uncorrelated", "with = \"l_prot_um\"");
  EXPECT_EQ(finding(e, uncorrelated).verdict, Verdict::undecided) << "r reaches from -0.6 to 0.6 in twelve runs";
  std::vector<Result>& runs = e.at("s").results;
  const std::vector<Result> twelve = runs;
  runs.insert(runs.end(), twelve.begin(), twelve.end());
  EXPECT_TRUE(holds(uncorrelated));
}

TEST(Judge, PrintsNoNumbersThatAreNone) {
  const Finding found =
      finding(evidence(f, {{1.0}, {}}), between("differs", 1, 2, up) + on("correlates", "with = \"l_prot_um\"" + up)
                                            + on("mean_above", "bound = 0.5"));
  EXPECT_EQ(found.verdict, Verdict::undecided);
  for (const auto& lines : {found.ours, found.conditions})
    for (const std::string& line : lines) EXPECT_EQ(line.find("nan"), std::string::npos) << line;
}

TEST(Judge, ComparesTwoReadOutsOfTheSameRuns) {
  Evidence e = evidence(f, apart);
  const std::vector<std::string> names = all_readouts();
  const auto force = static_cast<std::size_t>(std::ranges::find(names, "force_nN") - names.begin());
  const auto f_mat = static_cast<std::size_t>(std::ranges::find(names, f) - names.begin());
  double excess = 0.01;
  for (Result& r : e.at("s").results) r.readouts[force] = r.readouts[f_mat] + (excess += 1e-3); // little, but in each
  const auto verdict = [&](std::string_view high, std::string_view low) {
    return finding(e, fmt::format("{{ rule = \"exceeds\", readout = \"{}\", over = \"{}\", at = \"n_prot 1\" }}", high,
                                  low))
        .verdict;
  };
  EXPECT_EQ(verdict("force_nN", f), Verdict::holds);
  EXPECT_EQ(verdict(f, "force_nN"), Verdict::does_not_hold);
  EXPECT_EQ(verdict("tau_prot_min", f), Verdict::undecided);
}

TEST(Judge, IsUndecidedWithoutRuns) {
  EXPECT_EQ(finding(evidence(f, {{1.0}, {2.0, 3.0}}), between("differs", 1, 2, up)).verdict, Verdict::undecided);
  EXPECT_EQ(finding({}, between("same", 1, 2)).verdict, Verdict::undecided) << "no such study";
  EXPECT_EQ(finding({}, on("lowest_agrees", "value = 2, runs = 12")).verdict, Verdict::undecided);
  EXPECT_EQ(judged({.id = "A1", .study = "s"}, {}).verdict, Verdict::undecided) << "no condition";
}

TEST(Judge, NamesAPointThatIsNotThere) {
  Evidence e = evidence(f, apart);
  e.at("s").study.points[1].label = "two"; // a table that is kept of a study with other labels
  const Finding found = finding(evidence(f, apart), between("same", 2, 3));
  EXPECT_EQ(found.verdict, Verdict::holds);
  Claim claim;
  claim.study = "s";
  claim.conditions = {{.rule = &*std::ranges::find(claim_rules(), "same", &ClaimRule::name),
                       .from = {"", "n_prot 2"},
                       .to = {"", "n_prot 3"},
                       .readout = "f_mat"}};
  const Finding lost = judged(claim, e);
  EXPECT_EQ(lost.verdict, Verdict::undecided);
  EXPECT_NE(lost.conditions.front().find("n_prot 2 (no such point)"), std::string::npos) << lost.conditions.front();
}

TEST(Judge, TakesPointsOfOtherStudiesByTheirNames) {
  Evidence e = evidence(f, apart);
  e.emplace("t", e.at("s"));
  const Finding found = finding(e, on("differs", "from = \"n_prot 1\", to = \"t: n_prot 2\"" + up));
  EXPECT_EQ(found.verdict, Verdict::holds);
  EXPECT_TRUE(found.conditions.front().starts_with(
      "maturation of protrusions, mean: t: n_prot 2 significantly above s: n_prot 1"))
      << found.conditions.front();
  EXPECT_NE(finding(e, on("mean_above", "bound = 1, study = \"t\"")).conditions.front().find("over the runs of t"),
            std::string::npos);
}

TEST(Claims, AreComplete) {
  std::vector<std::string> ids;
  for (const Claim& claim : shipped_claims()) {
    ids.push_back(claim.id);
    EXPECT_EQ(judged(claim, {}).verdict, Verdict::undecided) << claim.id;
    for (const std::string& name : claim.studies()) EXPECT_NO_THROW(shipped_file(name)) << name;
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"A1", "A2", "A3", "A4", "A5", "A6", "A7", "A8", "B1", "B2", "B3",
                                           "B4", "C1", "C2", "C3", "C4", "C5", "D1", "D2", "D3", "D4", "E1",
                                           "E2", "E3", "E4", "E5", "X1", "X2", "X3", "X4", "X5"}));
  EXPECT_THROW(shipped_file("stifness"), std::out_of_range);
}

TEST(Claims, AreJudgedByTheStudiesThatTheyName) {
  for (const Claim& claim : shipped_claims()) {
    Evidence e;
    for (const std::string& name : claim.studies()) {
      const Study s = parse_study(shipped_file(name).text, name, ".");
      std::vector<Result> results;
      MsdCurves curves;
      for (std::size_t i = 0; i < s.points.size(); ++i)
        for (std::size_t k = 1; k <= 5; ++k) { // any numbers without much scatter, so that nothing is undecided
          std::vector<double> values(all_readouts().size());
          for (std::size_t v = 0; v < values.size(); ++v)
            values[v] = static_cast<double>(100 + 40 * ((i * 7 + v) % 11) + (k * k * 3 + v * k) % 11);
          Result& r = results.emplace_back();
          r.run.point = i;
          r.readouts = values;
          const double slope = 1.0 + 0.05 * static_cast<double>(i * 7 % 11) + 1e-3 * static_cast<double>(k);
          std::vector<MsdPoint>& curve = curves.emplace_back();
          for (const double lag : {600.0, 1200.0, 5400.0, 10800.0})
            curve.push_back({.lag = lag, .msd = std::pow(lag, slope), .samples = 10});
        }
      e.emplace(name, Ensemble{s, results, curves});
    }
    const Finding found = judged(claim, e);
    EXPECT_NE(found.verdict, Verdict::undecided) << claim.id;
    for (const std::string& line : found.conditions)
      EXPECT_EQ(line.find("no such point"), std::string::npos) << claim.id << ": " << line;
  }
}

TEST(Claims, AreTheSameFromAResolvedStudy) {
  const std::string scenario = "scenario = \"base.toml\"";
  for (const ReadStudy& shipped : read_shipped_studies()) {
    std::string text = to_toml(shipped.study, "base.toml");
    text.replace(text.find(scenario), scenario.size(), "preset = \"baseline\"");
    const Study again = parse_study(text, shipped.name, ".");
    ASSERT_EQ(again.claims.size(), shipped.study.claims.size()) << shipped.name;
    for (std::size_t i = 0; i < again.claims.size(); ++i) {
      EXPECT_EQ(again.claims[i].text, shipped.study.claims[i].text);
      EXPECT_EQ(again.claims[i].sentence, shipped.study.claims[i].sentence);
      EXPECT_EQ(again.claims[i].conditions.size(), shipped.study.claims[i].conditions.size());
    }
  }
}

TEST(Claims, AreThirtyWithThePartsAndHaveAKind) {
  std::map<ClaimKind, int> kinds;
  for (const Claim& claim : shipped_claims()) ++kinds[claim.kind];
  EXPECT_EQ(kinds, (std::map<ClaimKind, int>{
                       {ClaimKind::calibration, 19}, {ClaimKind::predicted, 7}, {ClaimKind::experiment, 5}}));
}

TEST(Claims, TableCallsAPointByItsValueUnlessTwoParametersEndAlike) {
  const auto brief = [](const std::string& sweep, const std::string& from, const std::string& to) {
    const std::string text = fmt::format("{}[[claims]]\nid = \"A1\"\nkind = \"predicted\"\nsentence = \"so it "
                                         "is\"\nconditions = [{{ rule = \"differs\", "
                                         "readout = \"f_mat\", from = \"{}\", to = \"{}\", sign = \"up\" }}]\n",
                                         sweep, from, to);
    Claim claim = read(text).claims.front();
    claim.study = "s";
    return judged(claim, Evidence{{"s", {read(text), results_of(f, {apart[0], apart[1]})}}}).brief;
  };
  EXPECT_EQ(brief("[sweep]\nprotrusion.force = [1, 2]\n", "force 1 nN", "force 2 nN"),
            "maturation of protrusions, mean: 1.15 [0.945, 1.36] (1 nN), 2.15 [1.94, 2.36] (2 nN)");
  EXPECT_EQ(brief("[sweep]\nprotrusion.force = [1, 2]\nactomyosin.force = [3]\n",
                  "protrusion.force 1 nN, actomyosin.force 3 nN", "protrusion.force 2 nN, actomyosin.force 3 nN"),
            "maturation of protrusions, mean: 1.15 [0.945, 1.36] (protrusion.force 1 nN, actomyosin.force 3 nN), "
            "2.15 [1.94, 2.36] (protrusion.force 2 nN, actomyosin.force 3 nN)");
}

TEST(Claims, TableSaysWhyNot) {
  const Evidence e = evidence(f, apart);
  const JudgedClaim no{"A1", ClaimKind::calibration, "f_mat rises and does not", "1 to 2",
                       finding(e, between("differs", 1, 2, up) + between("same", 1, 2))};
  const JudgedClaim yes{"B1", ClaimKind::predicted, "f_mat rises", "", finding(e, between("differs", 1, 2, up))};
  EXPECT_EQ(no.finding.brief,
            "maturation of protrusions, mean: 1.15 [0.945, 1.36] (n_prot 1), 2.15 [1.94, 2.36] (n_prot 2)");
  EXPECT_EQ(why_not(no.finding),
            "not met: maturation of protrusions, mean: n_prot 2 not significantly different from n_prot 1 "
            "(difference 1 [0.777, 1.22], g 6.7 [2.8, 11], p 3.4e-05)");
  EXPECT_EQ(why_not(yes.finding), "");
  EXPECT_EQ(bottom_line({no, yes}), "1 of 2 hold: 0 of 1 calibration, 1 of 1 predicted; 1 more in direction");
  EXPECT_TRUE(claims_csv({no, yes}).starts_with("id,kind,claim,published,ours,verdict,why_not,"));
  EXPECT_TRUE(conditions_csv({no, yes}).starts_with("id,sentence,published,ours,statistic,verdict,caveat\nA1,f_mat"));
}

/// A straight path of so many um each 600 s, for an hour.
std::string path(int replicate, double step, const std::string& more = "") {
  std::string rows;
  for (int k = 0; k <= 6; ++k) rows += fmt::format("{},{},{},0,{}n_prot 1\n", replicate, 600 * k, step * k, more);
  return rows;
}

TEST(RunMsd, TakesTheFirstTableThatHasARun) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "run_msd";
  std::filesystem::create_directories(folder);
  const std::string header = "replicate,t_s,x_um,y_um,point\n";
  write_file(folder / "first.csv", header + path(1, 1.0));
  write_file(folder / "second.csv", header + path(1, 5.0) + path(2, 2.0));
  const Study study = read("[sweep]\nprotrusion.number = [1]\n");
  const auto results = results_of("f_mat", {{0.5, 0.5, 0.5}});
  const MsdCurves msd = run_msd(study, results, {folder / "none.csv", folder / "first.csv", folder / "second.csv"});
  ASSERT_EQ(msd.size(), 3U);
  ASSERT_EQ(msd[0].size(), 3U);
  EXPECT_NEAR(msd[0][1].msd, 4.0, 1e-12);
  EXPECT_NEAR(msd[1][1].msd, 16.0, 1e-12);
  EXPECT_TRUE(msd[2].empty());
  write_file(folder / "cells.csv", "replicate,t_s,x_um,y_um,cell,point\n" + path(1, 1.0, "1,") + path(1, 3.0, "2,"));
  EXPECT_NEAR(run_msd(study, results, {folder / "cells.csv"})[0][0].msd, 5.0, 1e-12); // mean of 1 and 9
  for (const char* bad : {"replicate,t_s,x_um,point\n", "replicate,t_s,x_um,y_um\n", "t_s,x_um,y_um,point\n", ""}) {
    write_file(folder / "bad.csv", bad);
    EXPECT_THROW(run_msd(study, results, {folder / "bad.csv"}), InputOutputError) << bad;
  }
}

} // namespace
} // namespace matrigrate::study
