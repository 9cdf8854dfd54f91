#include "study_report/drawn_study.hpp"

#include "base/failure.hpp"
#include "unit/study_plan/studies.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace matrigrate::study {
namespace {

const std::string two_points = "readouts = [\"f_mat\"]\n[[points]]\nlabel = \"soft, \\\"50\\\"\"\n"
                               "ecm.youngs_modulus = 50\n[[points]]\nlabel = \"stiff\"\necm.youngs_modulus = 400\n";

TEST(DrawnStudy, IsMadeOfReadOutsAndTables) {
  const Study study = read(two_points);
  std::vector<Result> results = results_of("f_mat", {{0.1, 0.2}, {0.3, 0.4}});
  results.back().standing.status = RunState::failed;
  const auto data = drawn_study(
      study, results,
      {.paths = "replicate,t_s,x_um,y_um,point\n1,0,0.00,0.00,\"soft, \"\"50\"\"\"\n1,600,1.00,-0.50,\"soft, "
                "\"\"50\"\"\"\n2,0,0.00,0.00,\"soft, \"\"50\"\"\"\n1,0,0.00,0.00,stiff\n1,600,7.00,0.00,stiff\n",
       .shapes = "replicate,x_um,y_um,point\n1,1.00,2.00,stiff\n1,3.00,4.00,stiff\n",
       .msd = "lag_s,msd_um2,sem_um2,n_runs,point\n600,10,,1,stiff\n1200,40,,1,stiff\n1800,90,,1,stiff\n",
       .adhesions = "replicate,length_um,f_mat,f_adh_rel,point\n1,28.00,0.700,0.100,stiff\n1,28,0.7,1.5,stiff\n"});
  EXPECT_EQ(data.at("axes").size(), 1U);
  EXPECT_EQ(data.at("groups").size(), 2U);
  ASSERT_EQ(data.at("runs").size(), 4U);
  EXPECT_EQ(data.at("runs").at(0).at("readouts").at("f_mat"), 0.1);
  EXPECT_EQ(data.at("runs").at(0).at("path").at("x_um").dump(), "[0.0,1.0]");
  EXPECT_EQ(data.at("runs").at(0).at("path").at("y_um").dump(), "[0.0,-0.5]");
  EXPECT_TRUE(data.at("runs").at(0).at("outline").is_null());
  EXPECT_EQ(data.at("runs").at(2).at("path").at("x_um").dump(), "[0.0,7.0]") << "of its own point";
  EXPECT_EQ(data.at("runs").at(2).at("outline").at("y_um").dump(), "[2.0,4.0]");
  EXPECT_EQ(data.at("runs").at(2).at("f_adh_rel").dump(), "[0.1,1.5]");
  EXPECT_TRUE(data.at("runs").at(3).at("readouts").empty()) << "it is not done";
  ASSERT_EQ(data.at("msd").size(), 1U) << "of points that have one";
  EXPECT_EQ(data.at("msd").at(0).at("point"), data.at("runs").at(2).at("point"));
  EXPECT_EQ(data.at("msd").at(0).at("lag_min").dump(), "[10.0,20.0,30.0]");
  EXPECT_TRUE(std::isnan(data.at("msd").at(0).at("sem_um2").at(0).get<double>()));
  EXPECT_NEAR(data.at("msd").at(0).at("slope").get<double>(), 2.0, 1e-12);
}

TEST(DrawnStudy, PathsOfSeveralCellsAreApart) {
  Study study = read(two_points);
  study.points[0].parameters.cells = {{-16.0, 0.0}, {16.0, 0.0}};
  const auto data = drawn_study(study, results_of("f_mat", {{0.1}, {}}),
                                {.paths = "replicate,t_s,x_um,y_um,cell,point\n1,0,0,0,1,\"soft, \"\"50\"\"\"\n"
                                          "1,600,-2,0,1,\"soft, \"\"50\"\"\"\n1,0,0,0,2,\"soft, \"\"50\"\"\"\n",
                                 .shapes = {},
                                 .msd = {},
                                 .adhesions = {}});
  EXPECT_EQ(data.at("runs").at(0).at("path").at("x_um").dump(), "[0.0,-2.0,null,0.0]");
}

TEST(DrawnStudy, NeedsNoTables) {
  const Study study = read(two_points);
  const auto data = drawn_study(study, results_of("f_mat", {{0.1}, {0.2}}), {});
  EXPECT_TRUE(data.at("msd").empty());
  EXPECT_TRUE(data.at("runs").at(0).at("path").is_null());
  EXPECT_THROW(drawn_study(study, {}, {.paths = "a,point\n1,stiff\n", .shapes = {}, .msd = {}, .adhesions = {}}),
               InputOutputError);
}

} // namespace
} // namespace matrigrate::study
