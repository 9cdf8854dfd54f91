#include "store/saved_frames.hpp"

#include "base/file.hpp"
#include "store/deflate.hpp"
#include "store/field_file.hpp"
#include "store/frame_log.hpp"
#include "unit/observe/frames.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <span>
#include <utility>
#include <vector>

namespace matrigrate::store {
namespace {

/// A folder for the files of a film of two frames, at 300 and 600 s.
class SavedFramesTest : public testing::Test {
protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "matrigrate-saved-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
    shape = {.head = film.head, .outline = film.frames[0].outline.f_mat.size(), .fibres = false};
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  void write_log(const std::string& bytes) const { write_file(folder / frame_log_name, bytes); }
  void write_fields(const observe::Film& of) const { write_file(folder / field_file_name, field_file(of)); }
  std::vector<double> saved() const {
    std::vector<double> at;
    for (const auto& [t, frame] : saved_frames(folder, shape, times)) at.push_back(t);
    return at;
  }

  observe::Film film = SmallRun().film();
  FrameShape shape;
  std::vector<double> times{300.0, 600.0};
  std::filesystem::path folder;
};

TEST_F(SavedFramesTest, AreThoseOfTheLog) {
  write_log(log_bytes(film));
  const SavedFrames both = saved_frames(folder, shape, times);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both.at(600.0), log_frame(film.frames[1]));
  times = {300.0};
  EXPECT_EQ(saved(), (std::vector{300.0})) << "a later one is made again";
}

TEST_F(SavedFramesTest, AreAlsoTakenFromTheFieldFile) {
  EXPECT_EQ(saved(), std::vector<double>{});
  write_fields(film);
  EXPECT_EQ(saved(), times);
  write_log(log_bytes({.head = film.head, .frames = {film.frames[1]}}));
  EXPECT_EQ(saved_frames(folder, shape, times).at(300.0), log_frame(film.frames[0]))
      << "one of each, and the same bits";
  std::filesystem::remove(folder / field_file_name);
  EXPECT_EQ(saved(), (std::vector{600.0}));
}

TEST_F(SavedFramesTest, AreTakenFromADamagedFieldFileOneByOne) {
  std::string bytes = field_file(film);
  const std::string chunk = deflated_fast(byte_planes(std::span<const float>(film.frames[1].matrix.pressure)));
  const std::size_t at = bytes.rfind(chunk); // the first frame may have the same
  ASSERT_NE(at, std::string::npos);
  bytes[at + chunk.size() / 2] = static_cast<char>(bytes[at + chunk.size() / 2] ^ 1);
  write_file(folder / field_file_name, bytes);
  EXPECT_EQ(saved(), (std::vector{300.0}));
  ASSERT_EQ(saved_film(folder, shape, times).frames.size(), 1U);
  EXPECT_EQ(saved_film(folder, shape, times).frames[0].t, 300.0);
}

TEST_F(SavedFramesTest, AreFoundBehindADamagedHead) {
  std::string bytes = log_bytes(film);
  for (const std::size_t at : {std::size_t{0}, std::size_t{21}, std::size_t{100}}) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    write_log(damaged);
    EXPECT_EQ(saved(), times) << at;
  }
}

TEST_F(SavedFramesTest, AreNotTakenFromOtherBodies) {
  write_log(log_bytes(film));
  FrameShape other = shape;
  other.head.reference.pop_back();
  EXPECT_TRUE(saved_frames(folder, other, times).empty());
  other = shape;
  ++other.outline;
  EXPECT_TRUE(saved_frames(folder, other, times).empty());
}

TEST_F(SavedFramesTest, FollowABranchThatTurnsFibresOnOrOff) {
  write_log(log_bytes(film));
  FrameShape with = shape;
  with.fibres = true;
  const observe::Film fibrous = saved_film(folder, with, times);
  ASSERT_EQ(fibrous.frames.size(), film.frames.size());
  for (const auto& frame : fibrous.frames)
    EXPECT_EQ(frame.matrix.fibre_von_mises, observe::Floats(shape.head.particles(), 0.0F));
  write_log(log_bytes(fibrous));
  EXPECT_EQ(saved(), times) << "and back";
  for (const auto& frame : saved_film(folder, shape, times).frames) EXPECT_TRUE(frame.matrix.fibre_von_mises.empty());
}

TEST_F(SavedFramesTest, AreNotTakenFromNonsense) {
  write_log("nonsense");
  write_file(folder / field_file_name, "nonsense");
  EXPECT_EQ(saved(), std::vector<double>{});
  for (const std::size_t size : {0U, 10U, 19U, 20U, 30U, 100U}) {
    write_log(log_bytes(film).substr(0, size));
    EXPECT_EQ(saved(), std::vector<double>{}) << size;
  }
}

TEST(LostFrames, AreCountedAndTold) {
  const std::vector written{0.0, 30.0, 60.0, 90.0};
  EXPECT_EQ(lost_frames(written, written).count, 0U);
  EXPECT_EQ(to_text(lost_frames(written, written)), "");
  const LostFrames lost = lost_frames(written, std::vector{0.0, 90.0, 120.0});
  EXPECT_EQ(lost.count, 2U);
  EXPECT_EQ(lost.written, 4U);
  EXPECT_EQ(lost.first, 30.0);
  EXPECT_EQ(lost.last, 60.0);
  EXPECT_EQ(to_text(lost),
            "2 of 4 frames (from 30 s to 1 min) are lost: neither fields.part nor fields.h5 holds them whole");
  EXPECT_EQ(to_text(lost_frames(written, std::vector{0.0, 30.0, 60.0})),
            "1 of 4 frames (at 1 min 30 s) is lost: neither fields.part nor fields.h5 holds it whole");
}

} // namespace
} // namespace matrigrate::store
