#include "store/frame_log.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "unit/observe/frames.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdint>
#include <vector>

namespace matrigrate::store {
namespace {

TEST(FrameLog, GivesTheSameBitsBack) {
  const observe::Film film = SmallRun().film();
  EXPECT_EQ(difference(read_log(log_bytes(film)), film), "");
}

TEST(FrameLog, HoldsWhatVariesFromPlaceToPlace) {
  observe::Film film = SmallRun().film();
  film.head.obstacle.assign(film.head.particles(), 0);
  film.head.obstacle[7] = 1;
  film.head.layers.back().assign(film.head.particles(), 0.5F);
  for (observe::Frame& frame : film.frames)
    frame.matrix.attractant.assign(film.head.particles(), static_cast<float>(frame.t));
  const observe::Film read = read_log(log_bytes(film));
  EXPECT_EQ(difference(read, film), "");
  EXPECT_EQ(read.head.obstacle, film.head.obstacle);
  EXPECT_EQ(read.head.layers, film.head.layers);
  EXPECT_TRUE(read.head.layers.front().empty());
}

TEST(FrameLog, RefusesAHeadWhoseArraysDoNotBelongTogether) {
  for (std::size_t wrong = 0; wrong < observe::matrix_layers().size(); ++wrong) {
    observe::Film film = SmallRun().film();
    film.head.layers[wrong].assign(film.head.particles() - 1, 1.0F);
    EXPECT_THROW(read_log(log_bytes(film)), InputOutputError);
  }
  observe::Film film = SmallRun().film();
  film.head.obstacle.assign(film.head.particles() + 1, 0);
  EXPECT_THROW(read_log(log_bytes(film)), InputOutputError);
}

TEST(FrameLog, HoldsNuclei) {
  for (observe::Film film : {SmallRun().film(), TwoCells().film()}) {
    for (observe::Frame& frame : film.frames) frame.nucleus = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F, 8.0F};
    const observe::Film read = read_log(log_bytes(film));
    EXPECT_EQ(difference(read, film), "");
    EXPECT_EQ(read.frames[1].nucleus, film.frames[1].nucleus);
    EXPECT_TRUE(read.frames[1].matrix.attractant.empty());
    const std::vector<std::vector<Vec2>> nuclei = observe::nuclei_of(read.frames[1]);
    ASSERT_EQ(nuclei.size(), observe::outline_ends(film.frames[1].outline).size());
    EXPECT_EQ(nuclei.back().back(), Vec2(7.0, 8.0));
    EXPECT_EQ(nuclei.front().front(), Vec2(1.0, 2.0));
    EXPECT_EQ(nuclei.front().size() * nuclei.size(), 4U);
  }
  EXPECT_TRUE(observe::nuclei_of(SmallRun().film().frames[0]).empty());
}

TEST(FrameLog, TellsSeveralCellsApart) {
  const observe::Film film = TwoCells().film();
  EXPECT_EQ(difference(read_log(log_bytes(film)), film), "");
}

TEST(FrameLog, GrowsByWholeFrames) {
  const observe::Film film = SmallRun().film();
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("matrigrate-log-" + std::to_string(::getpid()));
  {
    FrameLog log(file, log_bytes({.head = film.head, .frames = {}}));
    for (const observe::Frame& frame : film.frames) log.add(frame);
    log.flush();
  }
  EXPECT_EQ(read_file(file, 1U << 30U), log_bytes(film));
  std::filesystem::remove(file);
}

std::vector<double> times(const observe::Film& film) {
  std::vector<double> all;
  for (const observe::Frame& frame : film.frames) all.push_back(frame.t);
  return all;
}

observe::Film four_frames() {
  observe::Film film = SmallRun().film();
  film.frames.insert(film.frames.end(), {film.frames[0], film.frames[1]});
  for (std::size_t k = 0; k < film.frames.size(); ++k) film.frames[k].t = 10.0 * static_cast<double>(k);
  return film;
}

TEST(FrameLog, EndsWhereItIsCutShort) {
  const observe::Film film = SmallRun().film();
  const std::string bytes = log_bytes(film);
  const std::size_t head = log_head(film.head).size();
  const std::size_t first = head + log_frame(film.frames[0]).size();
  for (std::size_t size = 0; size < bytes.size(); size += 97) {
    const std::string_view part = std::string_view(bytes).substr(0, size);
    if (size < head)
      EXPECT_THROW(read_log(part), InputOutputError) << size;
    else
      EXPECT_EQ(read_log(part).frames.size(), size < first ? 0U : 1U) << size;
  }
  EXPECT_EQ(read_log(std::string_view(bytes).substr(0, bytes.size() - 1)).frames.size(), 1U);
  EXPECT_THROW(read_log("matrigrate frames 2\n"), InputOutputError);
  EXPECT_THROW(read_log("nonsense"), InputOutputError);
}

TEST(FrameLog, LosesOnlyTheFramesThatAreDamaged) {
  const observe::Film film = four_frames();
  const std::size_t second = log_head(film.head).size() + log_frame(film.frames[0]).size();
  const std::size_t third = second + log_frame(film.frames[1]).size();
  for (std::size_t at = second; at < third; at += at < second + 24 ? 1 : 211) { // lengths and fingerprint: each byte
    std::string bytes = log_bytes(film);
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    EXPECT_EQ(times(read_log(bytes)), (std::vector{0.0, 20.0, 30.0})) << at;
  }
  std::string bytes = log_bytes(film);
  bytes.erase(third - 50, 100); // the end of one and the beginning of the next
  EXPECT_EQ(times(read_log(bytes)), (std::vector{0.0, 30.0}));
  bytes[second - 1] = static_cast<char>(bytes[second - 1] ^ 1); // and more damage before it
  EXPECT_EQ(times(read_log(bytes)), (std::vector{30.0}));
}

TEST(FrameLog, PassesOverFramesOfOtherBodies) {
  const observe::Film film = four_frames();
  for (const auto change : {+[](observe::Frame& f) { f.matrix.displacement.clear(); },
                            +[](observe::Frame& f) { f.matrix.f_degr.pop_back(); },
                            +[](observe::Frame& f) { f.matrix.fibre_von_mises = f.matrix.pressure; },
                            +[](observe::Frame& f) { f.outline.phase.pop_back(); },
                            +[](observe::Frame& f) { f.protrusions.anchor.push_back(0.0F); }}) {
    observe::Film other = film;
    change(other.frames[1]);
    EXPECT_EQ(times(read_log(log_bytes(other))), (std::vector{0.0, 20.0, 30.0}));
  }
}

TEST(FrameLog, GivesUpOnBytesThatLookLikeHeadsEverywhere) {
  const observe::Film film = four_frames();
  std::string bytes = log_head(film.head);
  const std::uint64_t length = 8 * film.head.particles();
  while (bytes.size() < (std::size_t{1} << 22U)) bytes.append(reinterpret_cast<const char*>(&length), sizeof(length));
  EXPECT_TRUE(read_log(bytes).frames.empty());
}

} // namespace
} // namespace matrigrate::store
