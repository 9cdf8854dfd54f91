#include "unit/study_plan/studies.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/run_msd.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace matrigrate::study {
namespace {

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
  write_file(folder / "bad.csv", "replicate,t_s,x_um,point\n");
  EXPECT_THROW(run_msd(study, results, {folder / "bad.csv"}), InputOutputError);
}

} // namespace
} // namespace matrigrate::study
