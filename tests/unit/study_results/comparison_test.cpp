#include "unit/study_plan/studies.hpp"

#include "study_results/comparison.hpp"
#include "tables/table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace matrigrate::study {
namespace {

using PairList = std::vector<std::pair<std::size_t, std::size_t>>;

TEST(Comparison, PairsOfAGrid) {
  const std::string grid = "[sweep]\necm.youngs_modulus = [50, 100, 200]\nprotrusion.number = [1, 2]\n[statistics]\n";
  EXPECT_EQ(compared_pairs(read(grid)), (PairList{{0, 1}, {0, 2}, {1, 3}, {2, 3}, {2, 4}, {3, 5}, {4, 5}}));
  EXPECT_EQ(compared_pairs(read(grid + "compare = \"all\"\n")).size(), 15U);
  EXPECT_TRUE(compared_pairs(read(grid + "compare = \"none\"\n")).empty());
  EXPECT_EQ(
      compared_pairs(read("[sweep]\nprotrusion.number = [1, 2, 3]\n[statistics]\ncompare = \"control\"\ncontrol = "
                          "\"n_prot 2\"\n")),
      (PairList{{1, 0}, {1, 2}}));
}

TEST(Comparison, DifferencesAndTheirCorrection) {
  const Study s = read("readouts = [\"f_mat\"]\n[sweep]\nprotrusion.number = [1, 2, 3]\n");
  const auto results = results_of("f_mat", {{0.1, 0.2, 0.3}, {0.6, 0.7, 0.8}, {0.65, 0.7, 0.85}});
  const std::vector<Comparison> c = comparisons(s, results);
  ASSERT_EQ(c.size(), 2U);
  EXPECT_NEAR(c[0].difference.value, 0.5, 1e-12);
  EXPECT_LT(c[0].test.p, 0.01);
  EXPECT_NEAR(c[0].p_holm, 2.0 * c[0].test.p, 1e-15);
  EXPECT_EQ(c[1].p_holm, c[1].test.p);
  EXPECT_NEAR(c[0].detectable, 0.3, 0.05);
  const std::string csv = statistics_csv(s, c, results);
  EXPECT_TRUE(csv.starts_with("readout,point_a,point_b,protrusion.number_a,protrusion.number_b,n_a,")) << csv;
  EXPECT_NE(csv.find("\nf_mat,n_prot 1,n_prot 2,1,2,3,3,"), std::string::npos) << csv;
  EXPECT_NE(groups_csv(s, results).find("\nf_mat,n_prot 3,3,3,"), std::string::npos);
}

// What differs between points makes no correlation within them: here r is 1 over all runs, -1 within.
TEST(Comparison, CorrelationsAreWithinPoints) {
  const Study s =
      read("readouts = [\"f_mat\", \"l_prot_um\", \"n_protrusions\"]\n[sweep]\nprotrusion.number = [1, 2]\n");
  std::vector<Result> results = results_of("f_mat", {{0.1, 0.2, 0.3}, {10.1, 10.2, 10.3}});
  for (Result& r : results) {
    const double f_mat = r.readouts[readout_column("f_mat")];
    r.readouts[readout_column("l_prot_um")] = f_mat > 1.0 ? 30.0 - f_mat : 1.0 - f_mat;
    r.readouts[readout_column("n_protrusions")] = f_mat > 1.0 ? 2.0 : 1.0; // without scatter within a point
  }
  const Correlations found = correlations(s, results);
  EXPECT_EQ(found.readouts, (std::vector<std::string>{"f_mat", "l_prot_um"}));
  EXPECT_NEAR(found.pairs[0][1].r, -1.0, 1e-9);
  EXPECT_EQ(found.p_holm[0][1], found.pairs[0][1].p) << "the only pair";
  const std::string csv = correlations_csv(found);
  EXPECT_TRUE(csv.starts_with("readout_x,readout_y,n,r,p,p_holm\nf_mat,f_mat,6,1,")) << csv;
}

TEST(Comparison, TheIntervalOfADifferenceIsThatOfTheTest) {
  const std::vector<double> a{0.1, 0.2, 0.3};
  const std::vector<double> b{0.2, 0.5, 0.6, 0.9, 1.3};
  for (const auto& [test, pooled] : {std::pair("t", true), std::pair("welch", false)}) {
    const Study s = read("readouts = [\"f_mat\"]\n[sweep]\nprotrusion.number = [1, 2]\n[statistics]\ntest = \""
                         + std::string(test) + "\"\n");
    const Comparison c = comparisons(s, results_of("f_mat", {a, b})).at(0);
    const statistics::Interval expected = statistics::mean_difference(a, b, s.comparisons.alpha, pooled);
    EXPECT_EQ(c.difference.low, expected.low) << test;
    EXPECT_EQ(c.difference.high, expected.high) << test;
  }
}

TEST(Comparison, TooFewRunsGiveEmptyFields) {
  const Study s = read("readouts = [\"f_mat\"]\n[sweep]\nprotrusion.number = [1, 2]\n");
  const auto results = results_of("f_mat", {{0.1}, {}});
  const std::string csv = statistics_csv(s, comparisons(s, results), results);
  EXPECT_NE(csv.find("\nf_mat,n_prot 1,n_prot 2,1,2,1,0,0.1,,,,,,,t,,,,,,,,,0,0\n"), std::string::npos) << csv;
}

TEST(Comparison, TablesHaveAColumnForEachSweptParameter) {
  const Study s = read("readouts = [\"f_mat\"]\n[sweep]\necm.youngs_modulus = [\"0.05 kPa\", \"100 Pa\"]\n"
                       "protrusion.number = [1, 2]\n");
  const auto results = results_of("f_mat", {{0.1, 0.2}, {0.3}, {0.4}, {0.5}});
  const std::string groups = groups_csv(s, results);
  EXPECT_TRUE(groups.starts_with("readout,point,ecm.youngs_modulus_Pa,protrusion.number,n,mean,")) << groups;
  EXPECT_NE(groups.find(",50,1,2,0.15"), std::string::npos) << groups;
  const std::string header = "readout,point_a,point_b,ecm.youngs_modulus_Pa_a,protrusion.number_a,"
                             "ecm.youngs_modulus_Pa_b,protrusion.number_b,n_a,";
  const std::string csv = statistics_csv(s, comparisons(s, results), results);
  EXPECT_TRUE(csv.starts_with(header)) << csv;
  EXPECT_NE(csv.find(",50,1,50,2,2,1,"), std::string::npos) << csv;
}

TEST(Results, ColumnsCarryUnits) {
  EXPECT_EQ(unit_suffix("Pa"), "_Pa");
  EXPECT_EQ(unit_suffix("1/s"), "_per_s");
  EXPECT_EQ(unit_suffix("nN s/um"), "_nN_s_per_um");
  EXPECT_EQ(unit_suffix("1"), "");
  const Study s = read("[sweep]\necm.youngs_modulus = [\"0.05 kPa\"]\nfibres.arrangement = [\"none\"]\n");
  const std::string csv = results_csv(s, results_of("f_mat", {{0.5}}));
  EXPECT_TRUE(csv.starts_with("run,label,ecm.youngs_modulus_Pa,fibres.arrangement,replicate,seed,status,")) << csv;
  EXPECT_NE(csv.find(",50,none,1,0,done,"), std::string::npos) << csv;
  const Study law = read("[set]\nlaws.constants = \"F_s = 200 pN, n = 2\"\n"
                         "[sweep]\nlaws.constants.F_s = [\"400 pN\"]\nlaws.constants.n = [1]\n");
  const std::string of_law = results_csv(law, results_of("f_mat", {{0.5}}));
  EXPECT_TRUE(of_law.starts_with("run,label,laws.constants.F_s_nN,laws.constants.n,replicate,")) << of_law;
  EXPECT_NE(of_law.find(",0.4,1,1,0,done,"), std::string::npos) << of_law;
}

TEST(Results, LabelsAreNoFormulas) {
  const Study s = read("readouts = [\"f_mat\"]\n[[points]]\nlabel = \"=cmd|'/c calc'!A1\"\nprotrusion.number = 1\n"
                       "[[points]]\nlabel = \"-1.5\"\nprotrusion.number = 2\n");
  const std::vector<Result> results = results_of("f_mat", {{0.5, 0.6}, {0.7, 0.8}});
  for (const std::string& csv :
       {results_csv(s, results), groups_csv(s, results), statistics_csv(s, comparisons(s, results), results)}) {
    EXPECT_NE(csv.find(",'=cmd|'/c calc'!A1,"), std::string::npos) << csv;
    EXPECT_EQ(csv.find(",=cmd"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",-1.5,"), std::string::npos) << csv;
  }
}

TEST(Results, TellWhichWayMeansLeanWhereRunsEndedAtTheRim) {
  const Study s = read("readouts = [\"f_mat\"]\n[set]\necm.radius = \"50 um\"\n[sweep]\nprotrusion.number = [1, 2]\n");
  std::vector<Result> results = results_of("f_mat", {{0.1, 0.2, 0.3}, {0.6, 0.7, 0.8}});
  EXPECT_EQ(rim_text(s, results), "");
  results[5].standing.status = RunState::failed;
  results[5].standing.cause = FailureCause::crossing;
  EXPECT_EQ(rim_text(s, results), "");
  for (const std::size_t k : {0, 3, 4}) {
    results[k].standing.status = RunState::failed;
    results[k].standing.cause = FailureCause::rim;
    results[k].readouts.assign(all_readouts().size(), std::numeric_limits<double>::quiet_NaN());
  }
  EXPECT_EQ(
      rim_text(s, results),
      "3 of 6 runs ended at the rim of the matrix (n_prot 1: 1 of 3; n_prot 2: 2 of 3): means are of the "
      "slower cells; take a larger ecm.radius. With ecm.radius = \"75 um\" under [set] and another folder (-o) the "
      "same seeds run in a disc 1.5 times as large.");
  const std::string groups = groups_csv(s, results);
  EXPECT_EQ(store::csv_column(groups, "lost_at_rim"), (std::vector<double>{1.0, 2.0})) << groups;
  const std::string csv = statistics_csv(s, comparisons(s, results), results);
  EXPECT_EQ(store::csv_column(csv, "lost_at_rim_a"), std::vector<double>{1.0}) << csv;
  EXPECT_EQ(store::csv_column(csv, "lost_at_rim_b"), std::vector<double>{2.0}) << csv;
}

TEST(Results, NumbersOfAColumn) {
  const std::string csv = "a,b_um,c\n1,2.5,x\n,,y\n3,-1e-3,z\n";
  const auto b = store::csv_column(csv, "b_um");
  ASSERT_EQ(b.size(), 3U);
  EXPECT_EQ(b[0], 2.5);
  EXPECT_TRUE(std::isnan(b[1]));
  EXPECT_EQ(b[2], -1e-3);
  EXPECT_TRUE(store::csv_column(csv, "d").empty());
  EXPECT_TRUE(store::csv_column("", "a").empty());
}

} // namespace
} // namespace matrigrate::study
