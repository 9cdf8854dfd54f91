#include "store/field_file.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "cell/geometry.hpp"
#include "observe/tracks.hpp"
#include "store/hdf5.hpp"
#include "unit/draw/markup.hpp"
#include "unit/observe/frames.hpp"
#include "unit/store/logs.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <array>
#include <cstdint>
#include <filesystem>

namespace matrigrate::store {
namespace {

/// The numbers of a view in a field file, as HDF5 reads it from a disk; MemoryFile refuses views.
observe::Floats view_in(const std::string& image, const char* name) {
  const auto path = std::filesystem::temp_directory_path() / ("views_" + std::to_string(::getpid()) + ".h5");
  write_file(path, image);
  observe::Floats values;
  {
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "no file");
    const Handle data(H5Dopen2(file.id(), name, H5P_DEFAULT), H5Dclose, "no view");
    const Handle space(H5Dget_space(data.id()), H5Sclose, "no shape");
    values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
    H5Dread(data.id(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
  std::filesystem::remove(path);
  return values;
}

/// The attributes of a field file, as any program reads them.
class Attributes {
public:
  explicit Attributes(std::string image) : m_image(std::move(image)), m_file(opened()) {}

  std::string text(const std::string& object, const char* name) const {
    const Handle attribute = found(object, name);
    const Handle type(H5Aget_type(attribute.id()), H5Tclose, "type");
    if (H5Tis_variable_str(type.id()) > 0) {
      char* value = nullptr;
      H5Aread(attribute.id(), type.id(), static_cast<void*>(&value));
      std::string copy(value);
      H5free_memory(value);
      return copy;
    }
    std::string value(H5Tget_size(type.id()), ' ');
    H5Aread(attribute.id(), type.id(), value.data());
    return value;
  }

  std::uint64_t number(const char* name) const {
    std::uint64_t value = 0;
    H5Aread(found("/", name).id(), H5T_NATIVE_UINT64, &value);
    return value;
  }

private:
  Handle opened() {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access");
    H5Pset_fapl_core(access.id(), 1U << 20U, 0);
    H5Pset_file_image(access.id(), m_image.data(), m_image.size());
    return {H5Fopen("attributes", H5F_ACC_RDONLY, access.id()), H5Fclose, "file"};
  }
  Handle found(const std::string& object, const char* name) const {
    return {H5Aopen_by_name(m_file.id(), object.c_str(), name, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, object + name};
  }

  std::string m_image;
  Handle m_file;
};

TEST(FieldFile, GivesTheSameBitsBack) {
  SmallRun run;
  EXPECT_EQ(difference(read_field_file(field_file(run.film())), run.film()), "");
  run.p.fibres.arrangement = FibreArrangement::isotropic;
  EXPECT_EQ(difference(read_field_file(field_file(run.film())), run.film()), "") << "with fibres";
  EXPECT_EQ(field_file(run.film()), field_file(run.film())) << "no date in it";
}

TEST(FieldFile, HoldsWhatVariesFromPlaceToPlace) {
  observe::Film film = SmallRun().film();
  EXPECT_FALSE(MemoryFile(field_file(film)).has("/matrix/obstacle"));
  film.head.obstacle.assign(film.head.particles(), 0);
  film.head.obstacle[7] = 1;
  for (observe::Floats& layer : film.head.layers) layer.assign(film.head.particles(), 150.0F);
  for (observe::Frame& frame : film.frames) frame.matrix.attractant.assign(film.head.particles(), 0.25F);
  const observe::Film read = read_field_file(field_file(film));
  EXPECT_EQ(difference(read, film), "");
  EXPECT_EQ(read.head.obstacle, film.head.obstacle);
  EXPECT_EQ(read.head.layers, film.head.layers);
  EXPECT_TRUE(MemoryFile(field_file(film)).has("/matrix/youngs_modulus"));
  EXPECT_TRUE(MemoryFile(field_file(film)).has("/matrix/ligand"));
  film.head.obstacle.pop_back();
  EXPECT_THROW(read_field_file(field_file(film)), InputOutputError);
}

TEST(FieldFile, HoldsNuclei) {
  observe::Film film = TwoCells().film();
  EXPECT_FALSE(MemoryFile(field_file(film)).has("/nucleus/position"));
  for (observe::Frame& frame : film.frames) frame.nucleus = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F, 8.0F};
  const observe::Film read = read_field_file(field_file(film));
  EXPECT_EQ(difference(read, film), "");
  EXPECT_EQ(read.frames[1].nucleus, film.frames[1].nucleus);
  for (observe::Frame& frame : film.frames) frame.nucleus.resize(6); // three particles of two cells
  EXPECT_THROW(read_field_file(field_file(film)), InputOutputError);
}

TEST(FieldFile, TellsSeveralCellsApart) {
  const observe::Film film = TwoCells().film();
  const std::string image = field_file(film);
  EXPECT_EQ(difference(read_field_file(image), film), "");
  const MemoryFile file(image);
  EXPECT_EQ(file.floats("/protrusions/cell"), (observe::Floats{1, 1, 5, 1, 5}));
  EXPECT_EQ(file.frame<float>("/outline/cell", 1), film.frames[1].outline.cell);
  EXPECT_FALSE(MemoryFile(field_file(SmallRun().film())).has("/outline/cell"));
  const std::string xml = field_index(&film.frames.front(), std::vector{0.0}, std::vector<std::size_t>{0});
  EXPECT_EQ(occurrences(xml, "NumberOfElements=\"2\" NodesPerElement=\"236\""), 1U);
  EXPECT_EQ(occurrences(xml, " 234 0 235 236 "), 1U) << "both lines are closed";
  EXPECT_EQ(occurrences(xml, " 469 235 <"), 1U);
}

TEST(FieldFile, NeedsNoFrames) {
  const observe::Film film{.head = SmallRun().film().head, .frames = {}};
  EXPECT_EQ(difference(read_field_file(field_file(film)), film), "");
}

TEST(FieldFile, HoldsPositionsInSpace) {
  const observe::Film film = SmallRun().film();
  const std::string image = field_file(film);
  const MemoryFile file(image);
  const observe::Floats x = file.frame<float>("/matrix/position", 1);
  ASSERT_EQ(x.size(), 3 * film.head.particles());
  EXPECT_EQ(x[3], film.head.reference[2] + film.frames[1].matrix.displacement[2]);
  EXPECT_EQ(x[5], 0.0F);
  EXPECT_EQ(file.frame<std::uint8_t>("/matrix/solid", 0)[3], 0);
  EXPECT_EQ(file.frame<std::uint8_t>("/matrix/solid", 0)[4], 1);
  EXPECT_EQ(view_in(image, "/frames/1/matrix/position"), x) << "a view, for readers of XDMF";
  EXPECT_THROW(file.frame<float>("/matrix/position", 2), InputOutputError);
  EXPECT_THROW(file.frame<float>("/matrix/nothing", 0), InputOutputError);
}

TEST(FieldFile, HoldsTheCellThatTracksSpeakOf) {
  SmallRun run;
  for (Vec2& x : run.s.cells[0].cortex.x) x += Vec2(3.0, -7.0);
  const observe::Film film = read_field_file(field_file(run.film()));
  const observe::Floats& x = film.frames[0].outline.x;
  CortexState read;
  for (std::size_t i = 0; i < x.size(); i += 2) read.x.emplace_back(x[i], x[i + 1]);
  EXPECT_LT((centre_of_mass(read) - track_row(run.s.cells[0], run.s.now()).centre).norm(), 1e-5) << "32 bits";
}

TEST(FieldFile, SaysWhatItIsOf) {
  const FieldOrigin origin{.program = "matrigrate",
                           .version = "0.1.0",
                           .seed = 9007199254740991,
                           .trajectory_hash = "0123456789abcdef",
                           .scenario = "[ecm]\nradius = \"40 \u00b5m\"\n"};
  const observe::Film film = SmallRun().film();
  const std::string image = field_file(film, origin);
  const Attributes file(image);
  EXPECT_EQ(file.text("/", "program"), origin.program);
  EXPECT_EQ(file.text("/", "version"), origin.version);
  EXPECT_EQ(file.number("seed"), origin.seed);
  EXPECT_EQ(file.text("/", "trajectory_hash"), origin.trajectory_hash);
  EXPECT_EQ(file.text("/", "scenario"), origin.scenario);
  EXPECT_EQ(field_file(film, origin), image) << "no date in it";
}

TEST(FieldFile, HasAUnitOnEveryArray) {
  const Attributes file(field_file(SmallRun().film()));
  for (const auto& [name, unit] : std::vector<std::pair<std::string, std::string>>{{"/time", "s"},
                                                                                   {"/matrix/solid", "1"},
                                                                                   {"/frames/0/matrix/pressure", "Pa"},
                                                                                   {"/frames/1/outline/phase", "1"},
                                                                                   {"/protrusions/frame", "1"},
                                                                                   {"/protrusions/phase", "1"},
                                                                                   {"/protrusions/force", "nN"},
                                                                                   {"/anchors/position", "um"},
                                                                                   {"/frames/0/anchors/force", "nN"}})
    EXPECT_EQ(file.text(name, "units"), unit) << name;
}

TEST(FieldFile, HoldsAdhesionsOfEachFrame) {
  const observe::Film film = SmallRun().film(); // one protrusion adheres in the first frame, none in the second
  const std::string image = field_file(film);
  const MemoryFile file(image);
  EXPECT_EQ(file.floats("/anchors/frame"), observe::Floats{0.0F});
  EXPECT_EQ(file.floats("/anchors/id"), observe::Floats{2.0F});
  EXPECT_EQ(view_in(image, "/frames/0/anchors/position"), (observe::Floats{30.5F, -1.25F, 0.0F}));
  EXPECT_EQ(view_in(image, "/frames/0/anchors/force"), observe::Floats{film.frames[0].protrusions.force[1]});
  EXPECT_FALSE(file.has("/frames/1/anchors/force"));
}

TEST(FieldFile, IsMadeOfALogFrameByFrame) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("matrigrate-fields-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const observe::Film film = SmallRun().film();
  EXPECT_THROW(write_field_files(folder, 2), InputOutputError) << "without a log";
  const std::string log = log_bytes(film);
  write_file(folder / frame_log_name, log.substr(0, log.size() - 1));
  EXPECT_THROW(write_field_files(folder, 2), InputOutputError) << "a frame is cut short";
  EXPECT_FALSE(std::filesystem::exists(folder / field_file_name));
  write_file(folder / frame_log_name, log);
  write_field_files(folder, 2);
  EXPECT_EQ(read_file(folder / field_file_name, 1U << 30U), field_file(film));
  EXPECT_EQ(difference(read_film(folder), film), "");
  std::filesystem::remove(folder / frame_log_name);
  EXPECT_EQ(difference(read_film(folder), film), "") << "of fields.h5";
  write_file(folder / frame_log_name, log_bytes({.head = film.head, .frames = {}}));
  write_field_files(folder, 0);
  EXPECT_TRUE(read_field_film(folder, Wanted::all).frames.empty());
  std::filesystem::remove_all(folder);
}

TEST(FieldFile, RefusesWhatItIsNot) { EXPECT_THROW(read_field_file("nonsense"), InputOutputError); }

TEST(FieldFile, RefusesArraysThatDoNotBelongTogether) {
  observe::Film film = SmallRun().film();
  film.head.reference.insert(film.head.reference.end(), {0.0F, 0.0F});
  for (observe::Frame& frame : film.frames)
    frame.matrix.displacement.insert(frame.matrix.displacement.end(), {0.0F, 0.0F});
  EXPECT_THROW(read_field_file(field_file(film)), InputOutputError);
}

TEST(FieldFile, RefusesAFrameThatIsShorterThanItSays) {
  const observe::Film film = SmallRun().film();
  const auto path = std::filesystem::temp_directory_path() / ("short_" + std::to_string(::getpid()) + ".h5");
  for (const std::uint32_t skipped : {0U, 3U}) { // filters
    write_file(path, field_file(film));
    {
      const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, "no file");
      const Handle data(H5Dopen2(file.id(), "/matrix/pressure", H5P_DEFAULT), H5Dclose, "no array");
      const std::string bytes = deflated_fast("short");
      const std::array<hsize_t, 2> second{1, 0};
      ASSERT_GE(H5Dwrite_chunk(data.id(), H5P_DEFAULT, skipped, second.data(), bytes.size(), bytes.data()), 0);
    }
    const std::string image = read_file(path, std::size_t{1} << 30U);
    EXPECT_THROW(read_field_file(image), InputOutputError);
    EXPECT_EQ(read_field_file(image, Wanted::whole).frames.size(), film.frames.size() - 1);
  }
  std::filesystem::remove(path);
}

TEST(FieldIndex, NamesGridsTimesAndArrays) {
  const observe::Film film = SmallRun().film();
  const std::string xml = field_index(&film.frames.front(), std::vector{film.frames[0].t, film.frames[1].t},
                                      std::vector<std::size_t>{2, 0});
  EXPECT_TRUE(parsed(xml.substr(xml.find("<Xdmf"))));
  EXPECT_EQ(occurrences(xml, "GridType=\"Uniform\""), 5U) << "matrix and outline, twice, and anchors once";
  EXPECT_EQ(occurrences(xml, "<Time Value=\"600\"/>"), 2U);
  EXPECT_EQ(occurrences(xml, "<Grid Name=\"anchors\" GridType=\"Uniform\">"), 1U)
      << "not at the time without an adhesion";
  EXPECT_EQ(occurrences(xml, "fields.h5:/frames/0/anchors/force<"), 1U);
  EXPECT_EQ(occurrences(xml, "fields.h5:/frames/1/matrix/position<"), 1U);
  EXPECT_EQ(occurrences(xml, "fibre"), 0U);
}

} // namespace
} // namespace matrigrate::store
