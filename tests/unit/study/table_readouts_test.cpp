#include "study/table_readouts.hpp"

#include "base/file.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace matrigrate::study {
namespace {

/// The read-outs of a run with these tracks and two mature adhesions.
std::array<double, 3> of_tracks(const std::string& tracks) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("matrigrate-table-readouts-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  write_file(folder / "tracks.csv", tracks);
  write_file(folder / "protrusions.csv", "id,f_adh_rel\n1,0.2\n2,0.9\n3,\n");
  const std::array<double, 3> values = table_readouts(folder);
  std::filesystem::remove_all(folder);
  return values;
}

} // namespace

TEST(TableReadouts, AreSharesOfAdhesionsAndTimes) {
  const auto values = of_tracks("t_s,x_um,y_um,n_simultaneous\n0,0,0,1\n600,3,4,2\n1200,3,4,3\n1800,3,4,4\n");
  EXPECT_DOUBLE_EQ(values[0], 0.5);
  EXPECT_DOUBLE_EQ(values[1], 0.5);
}

TEST(TableReadouts, TheMigrationIndexIsTheWayAlongXOverThePath) {
  // 5 um to (3, 4), 4 um down to (3, 0); the point at 300 s is left out.
  EXPECT_DOUBLE_EQ(of_tracks("t_s,x_um,y_um,n_simultaneous\n0,0,0,1\n300,-9,9,1\n600,3,4,1\n1200,3,0,1\n")[2],
                   3.0 / 9.0);
  EXPECT_TRUE(std::isnan(of_tracks("t_s,x_um,y_um,n_simultaneous\n0,1,1,1\n600,1,1,1\n")[2])) << "nothing moved";
  EXPECT_TRUE(std::isnan(of_tracks("t_s,cell,x_um,y_um,n_simultaneous\n0,1,0,0,1\n600,1,1,1,1\n")[2]))
      << "several cells";
}

} // namespace matrigrate::study
