#include "study/table_readouts.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace matrigrate::study {
namespace {

/// The read-outs of a run with these tracks and two mature adhesions.
std::vector<double> of_tracks(const std::string& tracks, const std::string& group = {}) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("matrigrate-table-readouts-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  write_file(folder / "tracks.csv", tracks);
  write_file(folder / "protrusions.csv", "id,f_adh_rel\n1,0.2\n2,0.9\n3,\n");
  if (!group.empty()) write_file(folder / "group.csv", group);
  const std::vector<double> values = table_readouts(folder);
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
}

TEST(TableReadouts, NeedTimesAndPlaces) {
  EXPECT_THROW(of_tracks("t_s,x_um,n_simultaneous\n0,0,1\n600,3,1\n"), InputOutputError);
  EXPECT_THROW(of_tracks("x_um,y_um,n_simultaneous\n0,0,1\n3,1,1\n"), InputOutputError);
}

TEST(TableReadouts, OfASingleCellThereIsNoGroup) {
  const auto values = of_tracks("t_s,x_um,y_um,n_simultaneous\n0,0,0,1\n600,3,4,1\n");
  ASSERT_EQ(values.size(), table_readout_table().size());
  for (std::size_t k = 3; k < values.size(); ++k) EXPECT_TRUE(std::isnan(values[k])) << table_readout_table()[k].name;
}

TEST(TableReadouts, OfSeveralCellsAreMeansAndWhatTheyDoTogether) {
  // The first cell goes straight away from the second, which goes at a right angle; the third, far off, goes towards
  // them.
  const auto values =
      of_tracks("track,t_s,x_um,y_um,n_simultaneous\n1,0,0,0,1\n2,0,30,0,1\n3,0,200,0,1\n"
                "1,600,-5,0,2\n2,600,30,5,2\n3,600,190,0,1\n",
                "t_s,order,nearest_um,n_contacts\n0,,30,1\n300,0.25,31,1\n600,0.75,32,0\n900,0.5,33,0\n");
  EXPECT_DOUBLE_EQ(values[1], 2.0 / 6.0) << "rows with two protrusions, of all cells";
  EXPECT_DOUBLE_EQ(values[2], (-1.0 + 0.0 - 1.0) / 3.0) << "migration index";
  EXPECT_DOUBLE_EQ(values[3], (1.0 + 0.0 - 1.0) / 3.0) << "parting index";
  EXPECT_DOUBLE_EQ(values[4], 0.5) << "share of times in contact";
  EXPECT_DOUBLE_EQ(values[5], 33.0) << "distance at the end";
  EXPECT_DOUBLE_EQ(values[6], 0.5) << "order";
}

} // namespace matrigrate::study
