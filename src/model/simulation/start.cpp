#include "simulation/start.hpp"

#include "cell/nucleus.hpp"
#include "parameters/schema.hpp"
#include "simulation/start_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace matrigrate {

State initial_state(const Parameters& p) {
  State s;
  s.ecm = disc(p);
  apply(matrix_fields(p), s.ecm);
  for (const CellStart& start : cell_starts(p)) {
    const auto id = static_cast<std::uint32_t>(s.cells.size());
    Cell& cell = s.cells.emplace_back();
    cell.id = id;
    cell.cortex = round_cortex(p.cell, start);
    cell.nucleus = round_nucleus(p, start);
  }
  return s;
}

namespace {

/// Parameters that the start was made with.
bool of_the_start(const Row& row, const Parameters& before) {
  if (kind(row) == Kind::field) return true;
  if (row.path == "ecm.youngs_modulus") return !before.ecm.fields.youngs_modulus.empty(); // fields are kept as ratios
  if (row.path == "fibres.stiffness") return !before.fibres.field.stiffness.empty();
  constexpr std::array<std::string_view, 11> fixed{"ecm.radius",     "ecm.particle_spacing", "ecm.smoothing_length",
                                                   "ecm.lattice",    "ecm.cell_hole",        "cell.radius",
                                                   "cell.particles", "cell.start_x",         "cell.start_y",
                                                   "nucleus.radius", "nucleus.particles"};
  return std::ranges::find(fixed, row.path) != fixed.end();
}

} // namespace

std::vector<Fault> faults_of_change(const Parameters& before, const Parameters& after, const std::string& place) {
  std::vector<Fault> faults;
  for (const Row& row : schema())
    if (of_the_start(row, before) && value_text(row, before) != value_text(row, after))
      faults.push_back({.file = place,
                        .key = std::string(row.path),
                        .message = fmt::format("a branch keeps the bodies of its run, made with {}; only a new run "
                                               "can have {}",
                                               value_text(row, before), value_text(row, after))});
  if (cells_text(before) != cells_text(after))
    faults.push_back({.file = place,
                      .key = "cells",
                      .message = "a branch keeps the cells of its run; only a new run can have others"});
  return faults;
}

} // namespace matrigrate
