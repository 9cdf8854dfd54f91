#include "base/failure.hpp"
#include "base/file.hpp"
#include "store/field_file.hpp"
#include "store/frame_log.hpp"
#include "store/hdf5.hpp"
#include "store/saved_frames.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <functional>
#include <string>

/// A fields.h5 that came from elsewhere names no other files and takes no more memory than it can fill.
namespace matrigrate::store {
namespace {

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

} // namespace
} // namespace matrigrate::store
