#include "claims/parts.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/shipped_studies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace matrigrate::study {
namespace {

const PartRow& row(std::string_view id) { return *std::ranges::find(part_rows(), id, &PartRow::id); }

validation::Check claim(double measured) {
  return {.quantity = "ratio [-]", .measured = measured, .expected = 1.0, .tolerance = 0.1, .reason = "why"};
}

validation::Result result(double check, double claimed) {
  validation::Result r;
  r.checks = {claim(check)};
  r.claims = {claim(claimed)};
  r.claim_notes = {"a note"};
  return r;
}

TEST(Parts, AreJudgedByTheClaimsOfACaseThatHolds) {
  const validation::Result good = result(1.0, 1.05);
  const JudgedClaim holds = judged_by_case(row("V2"), &good, "there");
  EXPECT_EQ(holds.id, "V2");
  EXPECT_EQ(holds.finding.verdict, Verdict::holds);
  EXPECT_EQ(holds.finding.brief, "ratio [-]: 1.05");
  EXPECT_EQ(holds.finding.ours, (std::vector<std::string>{"ratio [-]: 1.05", "a note"}));
  EXPECT_EQ(holds.finding.conditions, std::vector<std::string>{"within 0.1 of 1 (why): met"});
  const validation::Result off = result(1.0, 2.0);
  const JudgedClaim not_so = judged_by_case(row("V2"), &off, "there");
  EXPECT_EQ(not_so.finding.verdict, Verdict::does_not_hold);
  EXPECT_EQ(not_so.finding.unmet, std::vector<std::string>{"ratio [-]: 2, wanted within 0.1 of 1 (why)"});
  const validation::Result broken = result(2.0, 1.0);
  EXPECT_EQ(judged_by_case(row("V2"), &broken, "there").finding.verdict, Verdict::undecided);
  EXPECT_EQ(judged_by_case(row("V2"), nullptr, "there").finding.verdict, Verdict::undecided) << "it stopped";
  validation::Result without = good;
  without.claims.clear();
  EXPECT_EQ(judged_by_case(row("V2"), &without, "there").finding.verdict, Verdict::does_not_hold);
}

TEST(Parts, AreJudgedByKeptResultsOfACase) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "matrigrate_kept_case.json";
  std::filesystem::remove(file);
  EXPECT_EQ(judged_by_kept_case(row("V1"), file).finding.verdict, Verdict::undecided) << "no results are kept";
  write_file(file, R"({"cases": [{"holds": true, "claim_notes": ["a note"], "claims": [{"quantity": "ratio [-]",
    "measured": 2, "expected": 1, "tolerance": 0.1, "sense": "at_least", "reason": "why", "holds": true}]}]})");
  const JudgedClaim kept = judged_by_kept_case(row("V1"), file);
  EXPECT_EQ(kept.finding.verdict, Verdict::holds);
  EXPECT_EQ(kept.finding.conditions, std::vector<std::string>{"at least 1 (why): met"});
  for (const char* damaged : {"{", "{}", R"({"cases": []})", R"({"cases": [{"holds": true}]})"}) {
    write_file(file, damaged);
    EXPECT_THROW(judged_by_kept_case(row("V1"), file), InputOutputError) << damaged;
  }
  std::filesystem::remove(file);
}

/// By their labels, wherever they stand in the study.
TEST(Parts, FieldsAreOfPointsThatTheStudyHas) {
  const auto shipped = std::ranges::find(read_shipped_studies(), field_study, &ReadStudy::name);
  ASSERT_NE(shipped, read_shipped_studies().end());
  for (const std::string_view label : field_points)
    EXPECT_EQ(std::ranges::count(shipped->study.points, label, &Point::label), 1) << label;
}

} // namespace
} // namespace matrigrate::study
