#include "store/checkpoint.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "state/dof.hpp"
#include "state/initial.hpp"
#include "store/hdf5.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>

namespace matrigrate {
namespace {

using store::Checkpoint;

State lively_state() {
  Parameters p;
  p.ecm.radius = 30.0;
  State s;
  s.step = 12345;
  s.t = 4938.000000000001;
  s.ecm = disc(p);
  s.cells.emplace_back().cortex = round_cortex(p.cell);
  for (std::size_t i = 0; i < s.ecm.size(); ++i) {
    const double a = std::sin(static_cast<double>(i));
    s.ecm.x[i] += Vec2(a, 1.0 / 3.0 * a);
    s.ecm.v[i] = {-0.0, a * 1e-300};
    s.ecm.rho[i] = 1.0 + 0.1 * a;
    s.ecm.S[i] << a, 2 * a, 3 * a, 4 * a;
    s.ecm.f[i] = std::abs(a);
  }
  s.solver_memory.x_drag = s.ecm.x;
  s.solver_memory.x_drag[7] += Vec2(1e-3 / 3.0, 0.0);
  s.cells[0].cortex.v.assign(s.cells[0].cortex.size(), Vec2(0.1, 0.7));
  s.solver_memory.v_before.assign(s.ecm.size() + s.cells[0].cortex.size(), Vec2(0.2 / 3.0, -1.0));
  s.cells[0].polarization = 0.1 + 0.2;
  s.cells[0].initiated = 4;
  s.cells[0].protrusions = {
      {.centre = 3, .since = 0.1, .phase = Growing{{0.6, 0.8}, 44.0 / 3.0}, .record = {.id = 1}},
      {.centre = 50, .since = 1e-7, .phase = Maturing{{0, 1}, {1.0 / 3.0, 2}, 4, 1e-7}, .record = {.id = 2}},
      {.centre = 90, .since = 3, .phase = Contracting{{5, 6}, 0.7, 0.2, 1e-7}, .record = {.id = 3}},
      {.centre = 99, .since = 4, .phase = Finishing{0.9}, .record = {.id = 4}}};
  s.cells[0].ended = {
      {.id = 9, .centre = 7, .t_initiation = 0.4, .length = 1.0 / 7.0, .direction = -1.1, .cause = EndCause::rupture}};
  return s;
}

Checkpoint example() {
  return {.state = lively_state(),
          .scenario = "[run]\n",
          .configuration_hash = "0123",
          .program = "matrigrate 0",
          .memory = "{}"};
}

std::string refusal(std::string_view image) {
  try {
    store::parse_checkpoint(image, "c.h5");
  } catch (const InputOutputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Checkpoint, IsKnownByItsFirstBytes) {
  const auto file = std::filesystem::temp_directory_path() / ("junk_" + std::to_string(::getpid()) + ".h5");
  const auto expect_refused = [&file](const std::string& start, const std::string& why) {
    write_file(file, start);
    std::filesystem::resize_file(file, std::uintmax_t{8} << 30U); // more than is ever read
    try {
      store::read_checkpoint(file);
      ADD_FAILURE() << "accepted";
    } catch (const InputOutputError& error) {
      EXPECT_EQ(error.what(), file.string() + why);
    }
  };
  expect_refused("junk", ": is no checkpoint of matrigrate");
  expect_refused(store::checkpoint_image(example()), ": is cut short, or its first line has been changed");
  std::filesystem::remove(file);
}

TEST(Checkpoint, GivesTheSameBitsBack) {
  const Checkpoint before = example();
  const std::string image = store::checkpoint_image(before);
  const Checkpoint after = store::parse_checkpoint(image, "c.h5");
  EXPECT_EQ(after.scenario, before.scenario);
  EXPECT_EQ(after.configuration_hash, before.configuration_hash);
  EXPECT_EQ(after.program, before.program);
  EXPECT_EQ(after.memory, before.memory);
  EXPECT_EQ(store::checkpoint_image(after), image) << "every array and number";
  EXPECT_TRUE(std::signbit(after.state.ecm.v[0].x()));
  EXPECT_EQ(after.state.solver_memory.x_drag, before.state.solver_memory.x_drag);
  EXPECT_EQ(after.state.solver_memory.v_before, before.state.solver_memory.v_before);
  EXPECT_EQ(after.state.cells[0].polarization, before.state.cells[0].polarization);
  EXPECT_EQ(after.state.cells[0].protrusions.size(), 4U);
  EXPECT_EQ(std::get<Growing>(after.state.cells[0].protrusions[0].phase).base_width, 44.0 / 3.0);
  EXPECT_EQ(std::get<Maturing>(after.state.cells[0].protrusions[1].phase).steps, 4);
  EXPECT_EQ(std::get<Maturing>(after.state.cells[0].protrusions[1].phase).last_step, 1e-7);
  EXPECT_EQ(std::get<Contracting>(after.state.cells[0].protrusions[2].phase).bundle, 0.2);
  EXPECT_EQ(std::get<Contracting>(after.state.cells[0].protrusions[2].phase).falling, 1e-7);
  EXPECT_TRUE(std::isnan(after.state.cells[0].ended[0].t_adhesion));
}

TEST(Checkpoint, HoldsTheMatrixAlone) {
  Checkpoint matrix = example();
  matrix.state.cells.clear();
  matrix.state.solver_memory.v_before.clear();
  EXPECT_TRUE(store::parse_checkpoint(store::checkpoint_image(matrix), "c.h5").state.cells.empty());
}

TEST(Checkpoint, HoldsSeveralCells) {
  Checkpoint before = example();
  State& s = before.state;
  s.cells.push_back(s.cells[0]);
  s.cells[1].id = 9;
  s.cells[1].polarization = {};
  s.cells[1].protrusions.pop_back();
  s.cells[1].cortex.x[3] = {1.0 / 3.0, -7.0};
  s.solver_memory.v_before.resize(node_count(s), Vec2(0.1, 0.2));
  const std::string image = store::checkpoint_image(before);
  const Checkpoint after = store::parse_checkpoint(image, "c.h5");
  EXPECT_EQ(store::checkpoint_image(after), image) << "every array and number";
  ASSERT_EQ(after.state.cells.size(), 2U);
  EXPECT_EQ(after.state.cells[1].id, 9U);
  EXPECT_FALSE(after.state.cells[1].polarization);
  EXPECT_EQ(after.state.cells[1].protrusions.size(), 3U);
  EXPECT_EQ(after.state.cells[1].cortex.x[3], Vec2(1.0 / 3.0, -7.0));
  before.state.cells[1].cortex.l0.pop_back();
  EXPECT_TRUE(refusal(store::checkpoint_image(before)).ends_with("its arrays do not match in length"));
}

TEST(Checkpoint, HoldsNuclei) {
  Checkpoint before = example();
  Cell& cell = before.state.cells[0];
  cell.nucleus = cell.cortex;
  cell.nucleus.x[3] = {1.0 / 3.0, -7.0};
  before.state.solver_memory.v_before.resize(node_count(before.state), Vec2(0.1, 0.2));
  const std::string image = store::checkpoint_image(before);
  const Checkpoint after = store::parse_checkpoint(image, "c.h5");
  EXPECT_EQ(store::checkpoint_image(after), image);
  EXPECT_EQ(after.state.cells[0].nucleus.x, cell.nucleus.x);
  EXPECT_EQ(after.state.cells[0].nucleus.l0, cell.nucleus.l0);
  cell.nucleus.l0.pop_back();
  EXPECT_TRUE(refusal(store::checkpoint_image(before)).ends_with("its arrays do not match in length"));
}

TEST(Checkpoint, HoldsFieldsOfTheMatrix) {
  Checkpoint before = example();
  EcmState& ecm = before.state.ecm;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    ecm.E_ratio.push_back(1.0 + 1e-3 * static_cast<double>(i) / 3.0);
    ecm.fibre_direction.push_back(0.1 * static_cast<double>(i));
    ecm.obstacle.push_back(i % 3 == 0 ? 1 : 0);
    ecm.fibre_ratio.push_back(0.4 * static_cast<double>(i));
    ecm.ligand.push_back(0.2 * static_cast<double>(i));
    ecm.attractant.push_back(0.3 * static_cast<double>(i));
    ecm.attractant_source.push_back(0.01 * static_cast<double>(i % 2));
  }
  const std::string image = store::checkpoint_image(before);
  const Checkpoint after = store::parse_checkpoint(image, "c.h5");
  EXPECT_EQ(store::checkpoint_image(after), image) << "every array and number";
  EXPECT_EQ(after.state.ecm.E_ratio, ecm.E_ratio);
  EXPECT_EQ(after.state.ecm.fibre_direction, ecm.fibre_direction);
  EXPECT_EQ(after.state.ecm.obstacle, ecm.obstacle);
  EXPECT_EQ(after.state.ecm.fibre_ratio, ecm.fibre_ratio);
  EXPECT_EQ(after.state.ecm.ligand, ecm.ligand);
  EXPECT_EQ(after.state.ecm.attractant, ecm.attractant);
  EXPECT_EQ(after.state.ecm.attractant_source, ecm.attractant_source);
  ecm.E_ratio[5] = 0.0;
  EXPECT_TRUE(refusal(store::checkpoint_image(before)).ends_with("E_ratio of its matrix is out of range"));
  ecm.E_ratio.pop_back();
  EXPECT_TRUE(refusal(store::checkpoint_image(before)).ends_with("its arrays do not match in length"));
}

TEST(Checkpoint, RefusesOtherFilesWithTheirReason) {
  const std::string image = store::checkpoint_image(example());
  EXPECT_TRUE(refusal("").ends_with("c.h5: is no checkpoint of matrigrate"));
  EXPECT_TRUE(refusal("matrigrate checkpoint ").ends_with("is no checkpoint of matrigrate"));
  EXPECT_TRUE(refusal(image.substr(512)).ends_with("is no checkpoint of matrigrate")) << "plain HDF5";
  std::string other = image;
  other[22] = '7';
  EXPECT_EQ(refusal(other),
            "c.h5: is a checkpoint of format 7; this program reads format 9: resume with the version that "
            "wrote it, or start the run again from its scenario");
  for (const std::size_t length : {std::size_t{30}, std::size_t{511}, std::size_t{512}, image.size() - 1})
    EXPECT_NE(refusal(image.substr(0, length)).find("cut short"), std::string::npos) << length;
  EXPECT_NE(refusal(image + "x").find("cut short"), std::string::npos);
}

TEST(Checkpoint, RefusesEveryChangedByte) {
  const std::string image = store::checkpoint_image(example());
  for (std::size_t at = 0; at < image.size(); at += at < 600 ? 1 : 997) {
    std::string changed = image;
    changed[at] = static_cast<char>(changed[at] ^ 4);
    EXPECT_NE(refusal(changed), "accepted") << at;
  }
}

TEST(Checkpoint, RefusesArraysThatDoNotBelongTogether) {
  Checkpoint broken = example();
  broken.state.ecm.rho.pop_back();
  EXPECT_TRUE(refusal(store::checkpoint_image(broken)).ends_with("its arrays do not match in length"));
  broken = example();
  broken.state.cells[0].protrusions[0].centre = 100000;
  EXPECT_TRUE(refusal(store::checkpoint_image(broken)).ends_with("the centre of a protrusion is not on the cortex"));
}

TEST(Checkpoint, KeepsTheOneBefore) {
  std::string name = (std::filesystem::temp_directory_path() / "matrigrate-checkpoint-XXXXXX").string();
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  const std::filesystem::path folder = name;
  Checkpoint checkpoint = example();
  store::write_checkpoint(folder, checkpoint);
  EXPECT_FALSE(std::filesystem::exists(folder / store::previous_checkpoint_name));
  checkpoint.state.step = 2;
  store::write_checkpoint(folder, checkpoint);
  EXPECT_EQ(store::read_checkpoint(folder / store::checkpoint_name).state.step, 2U);
  EXPECT_EQ(store::read_checkpoint(folder / store::previous_checkpoint_name).state.step, 12345U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()), 2);
  std::filesystem::remove_all(folder);
  EXPECT_THROW(store::write_checkpoint(folder, checkpoint), InputOutputError);
}

TEST(Checkpoint, IsKeptBeforeItIsTheLast) {
  std::string name = (std::filesystem::temp_directory_path() / "matrigrate-checkpoint-XXXXXX").string();
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  const std::filesystem::path folder = name;
  const std::filesystem::path last = folder / store::checkpoint_name;
  EXPECT_THROW(store::write_checkpoint(folder, example(), folder / "missing" / "kept.h5"), InputOutputError);
  EXPECT_FALSE(std::filesystem::exists(last)) << "a resumed run would not keep it";
  store::write_checkpoint(folder, example(), folder / "kept.h5");
  EXPECT_EQ(read_file(folder / "kept.h5", 1U << 24U), read_file(last, 1U << 24U));
  std::filesystem::remove_all(folder);
}

TEST(MemoryFile, SaysWhatIsNotThere) {
  store::MemoryFile file;
  file.write("/a/x", std::vector<double>{1.0, 2.0}, "um");
  const store::MemoryFile read(file.view());
  EXPECT_EQ(read.array<double>("/a/x"), (std::vector<double>{1.0, 2.0}));
  EXPECT_THROW(read.array<double>("/a/y"), InputOutputError);
  EXPECT_THROW(read.array<Vec2>("/a/x"), InputOutputError) << "another shape";
  EXPECT_THROW(read.array<std::uint8_t>("/a/x"), InputOutputError) << "another type";
  EXPECT_THROW(store::MemoryFile("no HDF5"), InputOutputError);
}

} // namespace
} // namespace matrigrate
