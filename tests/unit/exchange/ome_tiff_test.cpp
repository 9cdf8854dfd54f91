#include "exchange/field_pictures.hpp"
#include "exchange/ome_tiff.hpp"

#include "fields/picture.hpp"
#include "unit/exchange/film.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace matrigrate::exchange {
namespace {

TEST(FieldPictures, HaveTheValueOfTheNearestParticle) {
  const observe::Film film = small_film();
  const PixelGrid grid = PixelGrid::over(film.head, 2.0);
  ASSERT_EQ(grid.side, 4U);
  EXPECT_EQ(grid.x(0), -3.0);
  EXPECT_EQ(grid.y(0), 3.0); // the upper edge is at the largest y
  const std::vector<Channel> all = channels(film);
  std::vector<std::string> names;
  for (const Channel& channel : all) names.push_back(channel.name);
  EXPECT_EQ(names, (std::vector<std::string>{"displacement_x", "displacement_y", "velocity_x", "velocity_y", "f_degr",
                                             "pressure", "von_mises", "youngs_modulus", "cell"}));
  const auto nearest = nearest_particles(film.head, film.frames[0], grid);
  const std::vector<float> pressure = picture(all[5], film.frames[0], grid, nearest);
  EXPECT_TRUE(std::isnan(pressure[0])); // beyond the disc
  EXPECT_EQ(pressure[1], 30.0F);
  EXPECT_EQ(pressure[2], 40.0F);
  EXPECT_EQ(pressure[4 * 3 + 1], 10.0F);
  EXPECT_EQ(pressure[4 * 3 + 2], 20.0F);
  EXPECT_EQ(picture(all[0], film.frames[0], grid, nearest)[4 * 3 + 2], 0.25F);
}

TEST(FieldPictures, KnowWhereTheCellIs) {
  const observe::Film film = small_film();
  const PixelGrid grid = PixelGrid::over(film.head, 1.0);
  const std::vector<float> cell = picture(channels(film).back(), film.frames[0], grid, {});
  double area = 0.0;
  for (const float number : cell) area += number;
  EXPECT_EQ(area, 4.0);
  EXPECT_EQ(cell[3 * 8 + 3], 1.0F);
}

TEST(OmeTiff, HasAPageForEachTimeAndChannelAndTheScale) {
  const observe::Film film = small_film();
  const std::string bytes = ome_tiff(film, 2.0, "a <title>", "1.2");
  for (const char* text : {"PhysicalSizeX=\"2\"", "SizeT=\"2\"", "SizeC=\"9\"", "TimeIncrement=\"300\"",
                           "Name=\"a &lt;title&gt;\"", "Name=\"pressure [Pa]\"", "PlaneCount=\"18\"", "DeltaT=\"300\""})
    EXPECT_NE(bytes.find(text), std::string::npos) << text;
  observe::Film uneven = film;
  uneven.frames.push_back(uneven.frames.back());
  uneven.frames.back().t = 500.0;
  const std::string without = ome_tiff(uneven, 2.0, "a title", "1.2");
  EXPECT_EQ(without.find("TimeIncrement"), std::string::npos) << "there is no one interval";
  EXPECT_NE(without.find("DeltaT=\"500\""), std::string::npos);
  // Pages with pixels beyond the disc are refused as fields, since they are not finite; that of the cells is not.
  const fields::Picture cells = fields::read_picture(bytes, {.page = 18, .channel = {}});
  EXPECT_EQ(cells.width, 4U);
  EXPECT_FALSE(cells.black);
  try {
    fields::read_picture(bytes, {.page = 1, .channel = {}});
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("no finite number in the pixel of column 1 and row 1"), std::string::npos);
  }
  EXPECT_THROW(fields::read_picture(bytes, {.page = 19, .channel = {}}), std::invalid_argument);
}

} // namespace
} // namespace matrigrate::exchange
