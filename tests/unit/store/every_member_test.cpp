#include "unit/store/every_member.hpp"
#include "unit/store/folder_of_tables.hpp"

#include "observe/frame.hpp"
#include "physics/gel.hpp"
#include "state/dof.hpp"
#include "state/image.hpp"
#include "state/members.hpp"
#include "tables/run_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace matrigrate {
namespace {

using every_member::Filler;
using every_member::listed;
using store::Checkpoint;
using store::RunMemory;

/// Every member has a value of its own, but for those that must fit to others.
Checkpoint full_checkpoint() {
  Checkpoint checkpoint;
  Filler filler;
  filler.fill(checkpoint);
  State& s = checkpoint.state;
  s.solver_memory.v_before.resize(node_count(s));
  for (Vec2& v : s.solver_memory.v_before) filler.fill(v);
  for (Cell& cell : s.cells)
    for (std::size_t k = 0; k < cell.protrusions.size(); ++k)
      cell.protrusions[k].centre = static_cast<std::uint32_t>(k); // a particle of the cortex
  return checkpoint;
}

RunMemory full_memory() {
  RunMemory memory;
  Filler().fill(memory);
  const std::vector<std::string_view> columns = store::track_columns(true);
  std::string& tracks = memory.tables["tracks.csv"] = store::csv_line({columns.begin(), columns.end()});
  for (const TrackRow& row : memory.rows) tracks += store::csv_line(store::fields(row));
  memory.tables["health.csv"] = "t_s\n0\n";
  const std::vector<std::string_view> group_columns = store::group_columns();
  std::string& group = memory.tables["group.csv"] = store::csv_line({group_columns.begin(), group_columns.end()});
  for (GroupRow& row : memory.group) {
    row.direction = 0.0; // is rounded in degrees
    group += store::csv_line(store::fields(row));
  }
  return memory;
}

TEST(EveryMember, OfACheckpointComesBack) {
  Checkpoint before = full_checkpoint();
  Checkpoint after = store::parse_checkpoint(store::checkpoint_image(before), "c.h5");
  EXPECT_EQ(listed(after), listed(before));
}

TEST(EveryMember, OfAnImageComesBack) {
  State before = full_checkpoint().state;
  State after = state_of(image_of(before));
  EXPECT_EQ(listed(after), listed(before));
  const std::string image = image_of(before);
  EXPECT_THROW(state_of(image.substr(0, image.size() - 1)), std::invalid_argument);
  EXPECT_THROW(state_of(image + "x"), std::invalid_argument);
  EXPECT_THROW(state_of("x" + image), std::invalid_argument);
}

/// The list of members names each member that the struct has, once.
template <class T>
void expect_all_listed() {
  T s;
  std::vector<const void*> there;
  std::vector<const void*> named;
  std::apply([&there](const auto&... member) { (there.push_back(&member), ...); }, every_member::members(s));
  std::vector<std::string> names;
  each_member(s, [&](const StateMember& member, const auto& value) {
    named.push_back(&value);
    names.emplace_back(member.name);
  });
  std::ranges::sort(there);
  std::ranges::sort(named);
  EXPECT_EQ(named, there);
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end()) << "two members of one name";
}

TEST(EveryMember, OfTheStateIsListed) {
  expect_all_listed<Growing>();
  expect_all_listed<Maturing>();
  expect_all_listed<Contracting>();
  expect_all_listed<Finishing>();
  expect_all_listed<ProtrusionRecord>();
  expect_all_listed<Protrusion>();
  expect_all_listed<CortexState>();
  expect_all_listed<Cell>();
  expect_all_listed<EcmState>();
  expect_all_listed<SolverMemory>();
  expect_all_listed<State>();
}

/// A change of any one number is seen by the comparison of bits, and comes back from checkpoint and image.
TEST(EveryMember, OfTheStateIsSeenWhenItChanges) {
  Checkpoint before = full_checkpoint();
  before.state.cells.resize(1);
  before.state.solver_memory.v_before.resize(node_count(before.state));
  const std::string unchanged = listed(before.state);
  std::size_t changes = 0;
  for (;; ++changes) {
    Checkpoint changed = before;
    every_member::Changer changer(changes);
    changer.change(changed.state);
    if (!changer.done()) break;
    const std::string expected = listed(changed.state);
    ASSERT_NE(expected, unchanged) << "change " << changes;
    EXPECT_FALSE(same_bits(changed.state, before.state)) << "change " << changes;
    State of_image = state_of(image_of(changed.state));
    EXPECT_EQ(listed(of_image), expected) << "change " << changes;
    State of_checkpoint = store::parse_checkpoint(store::checkpoint_image(changed), "c.h5").state;
    EXPECT_EQ(listed(of_checkpoint), expected) << "change " << changes;
  }
  EXPECT_GT(changes, 200U);
}

TEST(EveryMember, OfWhatARunHasWrittenComesBack) {
  const store::FolderOfTables folder;
  RunMemory before = full_memory();
  folder.write(before);
  RunMemory after = store::parse_memory(store::to_text(before), folder.path);
  EXPECT_EQ(listed(after), listed(before));
}

/// What is written of frames is what the tables of fields name, so each list of numbers must be in one of them.
TEST(EveryMember, OfAFrameIsInTheTablesOfFields) {
  observe::Frame frame{.t = 0.0, .matrix = {}, .outline = {}, .protrusions = {}};
  auto& [t, matrix, outline, protrusions, nucleus] = frame;
  auto& [displacement, velocity, f_degr, pressure, von_mises, fibre_von_mises, attractant] = matrix;
  auto& [x, f_mat, curvature, force, front, protrusion, phase, cell] = outline;
  auto& [id, centre, phase_now, anchor, maturation, pull, cell_number] = protrusions;
  std::vector<const void*> there{&displacement, &velocity,   &f_degr, &pressure,    &von_mises, &fibre_von_mises,
                                 &attractant,   &x,          &f_mat,  &curvature,   &force,     &front,
                                 &protrusion,   &phase,      &cell,   &id,          &centre,    &phase_now,
                                 &anchor,       &maturation, &pull,   &cell_number, &nucleus};
  std::vector<const void*> named;
  for (const auto& field : observe::float_fields()) named.push_back(&field.of(frame));
  for (const auto& field : observe::byte_fields()) named.push_back(&field.of(frame));
  std::ranges::sort(there);
  std::ranges::sort(named);
  EXPECT_EQ(named, there) << "at " << t << " s";
}

} // namespace
} // namespace matrigrate
