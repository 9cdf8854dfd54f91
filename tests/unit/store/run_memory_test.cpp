#include "store/run_memory.hpp"

#include "base/failure.hpp"

#include <gtest/gtest.h>

namespace matrigrate {
namespace {

using store::RunMemory;

RunMemory example_memory() {
  RunMemory memory;
  memory.rows = {{.t = 1.0 / 3.0, .step = 7, .centre = {0.1, -0.2}, .area = 5.0, .polarization = {}, .initiated = 2},
                 {.t = 60.0, .step = 9, .polarization = 0.3, .in_phase = {1, 0, 2, 3}}};
  memory.health = {{.t = 60.0, .step = 9, .max_iterations = 4, .density_min = 0.9, .crosses_itself = true}};
  memory.last = {.t = 61.2, .step = 11, .iterations = 5, .fastest = 0.1};
  memory.watch = {.max_iterations = 3, .largest_residual = 1e-5};
  memory.counts = {.solve = {.iterations = 2, .residual = 0.5, .converged = true}, .orphans = 3, .list_builds = 8};
  memory.scenes.emplace_back();
  memory.scenes[0].matrix[3] = {{1.0, 2.0}};
  memory.scenes[0].protrusions = {{.phase = 2, .contour = {{0.1, 0.2}}, .tip = {3, 4}, .anchor = Vec2(5, 6)}};
  memory.scenes[0].cells = {{.outline = {{1, 1}}, .front = {}, .path = {{7, 8}, {9, 10}}}};
  memory.frames = {0.0, 31.2};
  memory.trajectory = 0xfedcba9876543210U;
  memory.march_wall_time = 12.5;
  return memory;
}

TEST(RunMemory, GivesTheSameBitsBack) {
  const std::string text = store::to_text(example_memory());
  const RunMemory read = store::parse_memory(text);
  EXPECT_EQ(store::to_text(read), text) << "all of it";
  EXPECT_EQ(read.trajectory, 0xfedcba9876543210U);
  EXPECT_EQ(read.rows[0].t, 1.0 / 3.0);
  EXPECT_FALSE(read.rows[0].polarization);
  EXPECT_EQ(read.rows[1].in_phase[3], 3U);
  EXPECT_TRUE(read.health[0].crosses_itself);
  EXPECT_EQ(read.last->iterations, 5);
  EXPECT_EQ(read.counts.list_builds, 8U);
  EXPECT_EQ(read.scenes[0].protrusions[0].anchor->y(), 6.0);
}

TEST(RunMemory, HoldsSeveralCells) {
  RunMemory memory = example_memory();
  memory.rows[1].cell = 3;
  memory.scenes[0].cells.push_back({.outline = {{2, 2}, {3, 3}}, .front = {}, .path = {}});
  const std::string text = store::to_text(memory);
  const RunMemory read = store::parse_memory(text);
  EXPECT_EQ(store::to_text(read), text);
  EXPECT_EQ(read.rows[0].cell, 0U);
  EXPECT_EQ(read.rows[1].cell, 3U);
  ASSERT_EQ(read.scenes[0].cells.size(), 2U);
  EXPECT_EQ(read.scenes[0].cells[1].outline[1], Vec2(3, 3));
}

TEST(RunMemory, HoldsNuclei) {
  for (const bool several : {false, true}) {
    RunMemory memory = example_memory();
    memory.rows[1].nucleus = {.centre = {1.0 / 3.0, 2.0}, .area = 70.5, .aspect = 1.25};
    if (several) memory.scenes[0].cells.push_back({.outline = {{2, 2}}, .front = {}, .path = {}});
    memory.scenes[0].cells.back().nucleus = {{4, 5}, {6, 7}};
    const std::string text = store::to_text(memory);
    const RunMemory read = store::parse_memory(text);
    EXPECT_EQ(store::to_text(read), text);
    EXPECT_FALSE(read.rows[0].nucleus);
    ASSERT_TRUE(read.rows[1].nucleus);
    EXPECT_EQ(read.rows[1].nucleus->centre, Vec2(1.0 / 3.0, 2.0));
    EXPECT_EQ(read.rows[1].nucleus->area, 70.5);
    EXPECT_EQ(read.rows[1].nucleus->aspect, 1.25);
    ASSERT_EQ(read.scenes[0].cells.back().nucleus.size(), 2U);
    EXPECT_EQ(read.scenes[0].cells.back().nucleus[1], Vec2(6, 7));
  }
}

TEST(RunMemory, RefusesWhatItIsNot) {
  for (const char* text : {"", "{}", "[]", "{\"rows\": 3}", "null"})
    EXPECT_THROW(store::parse_memory(text), InputOutputError) << text;
}

} // namespace
} // namespace matrigrate
