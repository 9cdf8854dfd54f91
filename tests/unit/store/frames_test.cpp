#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/deflate.hpp"
#include "store/field_file.hpp"
#include "store/hdf5.hpp"
#include "store/saved_frames.hpp"
#include "unit/observe/frames.hpp"
#include "unit/store/logs.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace matrigrate::store {
namespace {

// A fields.h5 that came from elsewhere names no other files and takes no more memory than it can fill.

namespace fs = std::filesystem;

class ForeignFields : public ::testing::Test {
protected:
  fs::path folder = fs::temp_directory_path() / ("foreign_fields_" + std::to_string(::getpid()));
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  /// What becomes of an array /matrix/a made by `make` in a file.
  std::string refusal(
      const std::function<void(hid_t file)>& make,
      const std::function<void(const MemoryFile&)>& read = [](const MemoryFile& f) { f.floats("/matrix/a"); }) const {
    const std::string path = (folder / "made.h5").string();
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    make(file);
    H5Fclose(file);
    try {
      const MemoryFile made(read_file(path, 1U << 24U));
      read(made);
    } catch (const InputOutputError& error) {
      return error.what();
    }
    return "accepted";
  }
};

void group(hid_t file) { H5Gclose(H5Gcreate2(file, "/matrix", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)); }

/// An array that is not written. @param creation  closed here
void array(hid_t file, hid_t creation, const std::vector<hsize_t>& shape) {
  const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  H5Dclose(H5Dcreate2(file, "/matrix/a", H5T_NATIVE_FLOAT, space, H5P_DEFAULT, creation, H5P_DEFAULT));
  H5Sclose(space);
  H5Pclose(creation);
}

TEST_F(ForeignFields, MustNotKeepNumbersInAnotherFile) {
  const auto make = [](hid_t file) {
    group(file);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(creation, "/etc/hostname", 0, 4);
    array(file, creation, {1});
  };
  EXPECT_EQ(refusal(make), "HDF5: /matrix/a keeps its numbers in another file");
}

TEST_F(ForeignFields, MustNotLink) {
  const auto of_file = [](hid_t file) {
    group(file);
    H5Lcreate_external("/other.h5", "/a", file, "/matrix/a", H5P_DEFAULT, H5P_DEFAULT);
  };
  EXPECT_EQ(refusal(of_file), "HDF5: /matrix/a is a link to another place");
  const auto of_group = [](hid_t file) {
    H5Lcreate_external("/other.h5", "/", file, "/matrix", H5P_DEFAULT, H5P_DEFAULT);
  };
  EXPECT_EQ(refusal(of_group), "HDF5: /matrix is a link to another place");
  EXPECT_EQ(refusal(of_group, [](const MemoryFile& f) { f.has("/matrix/a"); }),
            "HDF5: /matrix is a link to another place");
  const auto soft = [](hid_t file) {
    group(file);
    H5Lcreate_soft("/elsewhere", file, "/matrix/a", H5P_DEFAULT, H5P_DEFAULT);
  };
  EXPECT_EQ(refusal(soft), "HDF5: /matrix/a is a link to another place");
}

TEST_F(ForeignFields, MustNotBeViews) {
  const auto make = [](hid_t file) {
    group(file);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    const hsize_t n = 4;
    const hid_t space = H5Screate_simple(1, &n, nullptr);
    H5Pset_virtual(creation, space, "/other.h5", "/a", space);
    H5Sclose(space);
    array(file, creation, {n});
  };
  EXPECT_EQ(refusal(make), "HDF5: /matrix/a is a view of other arrays");
}

TEST_F(ForeignFields, MustNotBeLargerThanTheFile) {
  const auto unwritten = [](hid_t file) {
    group(file);
    array(file, H5Pcreate(H5P_DATASET_CREATE), {hsize_t{1} << 30U});
  };
  EXPECT_EQ(refusal(unwritten), "HDF5: /matrix/a is not written: it holds too few bytes");
  const auto frames = [](std::size_t n, std::size_t numbers) {
    return [=](const MemoryFile& f) { f.require_frames("/matrix/a", n, numbers); };
  };
  const auto chunked = [](const std::array<hsize_t, 2>& chunk) {
    return [chunk](hid_t file) {
      group(file);
      const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
      H5Pset_chunk(creation, 2, chunk.data());
      array(file, creation, {10, 1000});
    };
  };
  EXPECT_EQ(refusal(chunked({1, 1000}), frames(10, 1000)), "HDF5: /matrix/a is not written: it holds too few bytes");
  EXPECT_EQ(refusal(chunked({10, 1000}), frames(10, 1000)), "HDF5: /matrix/a is not stored frame by frame");
  EXPECT_EQ(refusal(chunked({1, 1000}), frames(10, 900)), "HDF5: /matrix/a has 1000 numbers a frame instead of 900");
  EXPECT_EQ(refusal(chunked({1, 1000}), frames(9, 1000)), "HDF5: /matrix/a has 10 frames instead of 9");
}

TEST_F(ForeignFields, OfARunAreToldWithTheReason) {
  write_file(folder / field_file_name, "junk");
  ASSERT_EQ(::mkfifo((folder / frame_log_name).c_str(), 0600), 0) << "nobody writes into it";
  std::string trouble;
  const observe::Film film = saved_film(folder, {}, std::array{0.0}, &trouble);
  EXPECT_TRUE(film.frames.empty());
  EXPECT_EQ(trouble, (folder / field_file_name).string() + ": HDF5: not an HDF5 file");
}

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
  }
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
  for (const auto change :
       {+[](observe::Frame& f) { f.matrix.displacement.clear(); },
        +[](observe::Frame& f) { f.matrix.f_degr.pop_back(); },
        +[](observe::Frame& f) { f.matrix.fibre_von_mises = f.matrix.pressure; },
        +[](observe::Frame& f) { f.outline.phase.pop_back(); },
        +[](observe::Frame& f) { f.protrusions.anchor.push_back(0.0F); },
        +[](observe::Frame& f) { f.protrusions.id[0] = -1.0F; }, +[](observe::Frame& f) { f.protrusions.id[0] = 1e9F; },
        +[](observe::Frame& f) { f.protrusions.centre[0] = 1.5F; },
        +[](observe::Frame& f) { f.protrusions.centre[0] = NAN; }}) {
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
