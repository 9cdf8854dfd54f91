#include "exchange/vtk_files.hpp"

#include "unit/draw/markup.hpp"
#include "unit/observe/frames.hpp"

#include <gtest/gtest.h>

namespace matrigrate::exchange {
namespace {

std::string body(const std::string& xml) { return xml.substr(xml.find("<VTKFile")); }

TEST(VtkFiles, HaveALineForEachCell) {
  const std::string outline = outline_vtp(TwoCells().film().frames[0]);
  EXPECT_TRUE(parsed(body(outline)));
  EXPECT_EQ(occurrences(outline, "NumberOfLines=\"2\""), 1U);
  EXPECT_EQ(occurrences(outline, "Name=\"cell\""), 1U);
  EXPECT_EQ(occurrences(outline_vtp(SmallRun().film().frames[0]), "Name=\"cell\""), 0U);
}

TEST(VtkFiles, HoldPointsFieldsAndTimes) {
  const observe::Film film = SmallRun().film();
  const std::string matrix = matrix_vtp(film.head, film.frames[0]);
  EXPECT_TRUE(parsed(body(matrix)));
  EXPECT_EQ(occurrences(matrix, "NumberOfPoints=\"" + std::to_string(film.head.particles()) + "\""), 1U);
  for (const char* name : {"displacement", "velocity", "f_degr", "pressure", "von_mises", "solid"})
    EXPECT_EQ(occurrences(matrix, "Name=\"" + std::string(name) + "\""), 1U) << name;
  const std::string outline = outline_vtp(film.frames[0]);
  EXPECT_TRUE(parsed(body(outline)));
  EXPECT_EQ(occurrences(outline, "NumberOfLines=\"1\""), 1U);
  EXPECT_EQ(occurrences(outline, "Name=\"phase\""), 1U);
  EXPECT_EQ(occurrences(matrix + outline, "format=\"ascii\""), 0U);
  const std::string adhesions = anchors_vtp(film.frames[0]);
  EXPECT_TRUE(parsed(body(adhesions)));
  EXPECT_EQ(occurrences(adhesions, "NumberOfPoints=\"1\""), 1U);
  EXPECT_EQ(occurrences(anchors_vtp(film.frames[1]), "NumberOfPoints=\"0\""), 1U);
  EXPECT_EQ(occurrences(anchors_vtp(film.frames[1]), "AAAAAAAAAAAAAAAA"), 6U) << "arrays of nothing: no blocks";
  const std::string series = series_pvd("matrix", film);
  EXPECT_EQ(occurrences(series, "<DataSet timestep=\"600\" part=\"0\" file=\"matrix_0001.vtp\"/>"), 1U);
}

} // namespace
} // namespace matrigrate::exchange
