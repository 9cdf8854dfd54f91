#include "unit/store/every_member.hpp"

#include "observe/frame.hpp"
#include "state/dof.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

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
  for (observe::CellScene& scene : memory.scenes)
    for (std::size_t k = 0; k < scene.protrusions.size(); ++k) scene.protrusions[k].phase = k;
  return memory;
}

TEST(EveryMember, OfACheckpointComesBack) {
  const auto single = [](Checkpoint& c) { // as older programs read it
    c.state.cells.resize(1);
    c.state.cells[0].id = 0;
    c.state.cells[0].nucleus = {};
    EcmState& m = c.state.ecm;
    m.E_ratio = m.fibre_direction = m.fibre_ratio = m.ligand = m.attractant = m.attractant_source = {};
    m.obstacle = {};
  };
  const auto no_nuclei = [](Checkpoint& c) {
    for (Cell& cell : c.state.cells) cell.nucleus = {};
  };
  const auto whole = [](Checkpoint&) {};
  for (const std::function<void(Checkpoint&)>& leave_out :
       {std::function<void(Checkpoint&)>(whole), std::function<void(Checkpoint&)>(no_nuclei),
        std::function<void(Checkpoint&)>(single)}) {
    Checkpoint before = full_checkpoint();
    leave_out(before);
    before.state.solver_memory.v_before.resize(node_count(before.state));
    Checkpoint after = store::parse_checkpoint(store::checkpoint_image(before), "c.h5");
    EXPECT_EQ(listed(after), listed(before));
  }
}

TEST(EveryMember, OfWhatARunHasWrittenComesBack) {
  RunMemory before = full_memory();
  RunMemory after = store::parse_memory(store::to_text(before));
  EXPECT_EQ(listed(after), listed(before));
  for (observe::CellScene& scene : before.scenes) scene.cells.resize(1); // a single cell is written in another way
  after = store::parse_memory(store::to_text(before));
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
