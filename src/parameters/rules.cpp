#include "parameters/rules.hpp"

#include "parameters/changes.hpp"
#include "parameters/laws/law.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace matrigrate {

namespace {

constexpr double max_particles = 4e6;
constexpr double max_steps = 1e9;

std::string support(const Parameters& p) {
  const double ratio = p.ecm.smoothing_length / p.ecm.particle_spacing;
  const double slack = 1e-9; // 7.8 um over 2.6 um is 3
  if (ratio >= 1.0 - slack && ratio <= 3.0 + slack) return {};
  return fmt::format(
      "smoothing length over particle spacing is {:.3g}; allowed is 1 to 3: with less a particle has too "
      "few neighbours to carry stress, with more the matrix is smeared out",
      ratio);
}

std::string room(const Parameters& p) {
  const double free_radius = p.ecm.radius - 2.0 * p.ecm.smoothing_length;
  if (free_radius >= 2.0 * p.ecm.particle_spacing) return {};
  return fmt::format(
      "a disc of {:.4g} um is clamped throughout: its rim is 2 smoothing lengths wide; allowed is >= {:.4g} um",
      p.ecm.radius, 2.0 * (p.ecm.smoothing_length + p.ecm.particle_spacing));
}

std::string hole(const Parameters& p) {
  if (!p.cells.empty()) return {}; // said by cell_faults()
  const double hole_radius = std::hypot(p.cell.start_x, p.cell.start_y) + p.cell.radius + p.degradation.body_distance;
  const double free_radius = p.ecm.radius - 2.0 * p.ecm.smoothing_length;
  if (hole_radius < free_radius) return {};
  return fmt::format(
      "the cell and its margin reach {:.4g} um from the centre, but the matrix is clamped from {:.4g} um on; "
      "take a smaller cell, a start nearer to the centre, or a larger disc",
      hole_radius, free_radius);
}

/// A cue that initiation senses: where a law of it depends on `argument` (the defaults depend on none), there must be
/// something to sense.
/// @param keys  of what there is to sense
Rule to_sense(std::string name, std::string_view argument, std::vector<std::string_view> keys,
              bool (*is_there)(const Parameters&), const char* missing) {
  constexpr std::array laws{"laws.initiation_bias", "laws.initiation_rate"};
  keys.insert(keys.begin(), {laws[0], laws[1], "laws.constants"});
  const auto broken = [=](const Parameters& p) -> std::string {
    const auto senses = [&](std::string_view path) {
      return is_changed(*find_row(path), p) && Law(path, p).uses(argument);
    };
    return std::ranges::any_of(laws, senses) && !is_there(p) ? missing : "";
  };
  return {
      std::move(name), std::move(keys), broken, {readable_rule(*find_row(laws[0])), readable_rule(*find_row(laws[1]))}};
}

std::string fibre_stiffness(const Parameters& p) {
  if (p.fibres.field.stiffness.empty() || p.fibres.stiffness > 0.0) return {};
  return "a field of fibre stiffness is taken relative to fibres.stiffness, which must be above 0 Pa";
}

std::string source(const Parameters& p) {
  if (p.ecm.fields.attractant_source.empty() || p.cues.diffusion > 0.0) return {};
  return "attractant that is released without diffusion would accumulate at its source; set cues.diffusion above 0 "
         "um^2/s";
}

std::string one_start(const Parameters& p) {
  if (p.cells.empty() || (p.cell.start_x == 0.0 && p.cell.start_y == 0.0)) return {};
  return "is the start of a single cell, but [[cells]] gives the starts of all cells; leave this key out, or at 0";
}

std::string several_cells(const Parameters& p) {
  const std::vector<CellFault> faults = cell_faults(p);
  return faults.empty() ? "" : fmt::format("cell {} {}", faults.front().cell + 1, faults.front().message);
}

std::string nucleus_fits(const Parameters& p) {
  const double most = p.cell.radius - p.nucleus.repulsion_range;
  if (p.nucleus.radius == 0.0 || p.nucleus.radius <= most) return {};
  if (most <= 0.0)
    return fmt::format(
        "there is no room for a nucleus: its repulsion reaches {:.4g} um, and the cell's radius is {:.4g} "
        "um",
        p.nucleus.repulsion_range, p.cell.radius);
  return fmt::format(
      "a nucleus of radius {:.4g} um does not fit into a cell of {:.4g} um; allowed is <= {:.4g} um, the "
      "cell's radius less the range of the repulsion",
      p.nucleus.radius, p.cell.radius, most);
}

std::string nucleus_spacing(const Parameters& p) {
  const double l = 2.0 * p.nucleus.radius * std::sin(std::numbers::pi / p.nucleus.particles);
  const double most = 2.0 * p.nucleus.repulsion_range;
  if (l <= most) return {};
  return fmt::format(
      "particles of the nucleus lie {:.3g} um apart, so the cortex could pass between them; allowed is <= {:.3g} um, "
      "twice the range of the repulsion: take {} particles or more",
      l, most, static_cast<long>(std::ceil(2.0 * std::numbers::pi * p.nucleus.radius / most)));
}

std::string resolution(const Parameters& p) {
  if (3.0 * p.ecm.particle_spacing <= p.cell.radius) return {};
  return fmt::format("particles {:.4g} um apart are too coarse for a cell of radius {:.4g} um; allowed is a spacing <= "
                     "{:.4g} um",
                     p.ecm.particle_spacing, p.cell.radius, p.cell.radius / 3.0);
}

std::string protrusion_width(const Parameters& p) {
  if (2 * p.protrusion.half_width + 1 <= p.cell.particles / 2) return {};
  return fmt::format("a protrusion of {} particles takes more than half of the cortex, which has {}; allowed is a "
                     "half_width <= {}",
                     2 * p.protrusion.half_width + 1, p.cell.particles, (p.cell.particles / 2 - 1) / 2);
}

std::string tip_width(const Parameters& p) {
  if (p.protrusion.tip_half_width <= p.protrusion.half_width) return {};
  return fmt::format("the pushing tip reaches {} particles to each side, but the protrusion only {}",
                     p.protrusion.tip_half_width, p.protrusion.half_width);
}

std::string pinned_base(const Parameters& p) {
  if (p.adhesion.pinned_particles <= p.protrusion.half_width + 1) return {};
  return fmt::format("{} pinned particles at either end are more than a protrusion has; allowed are <= {}",
                     p.adhesion.pinned_particles, p.protrusion.half_width + 1);
}

std::string supports(const Parameters& p) {
  if (p.ecm.orphan_support < p.ecm.support_floor) return {};
  return fmt::format("ecm.orphan_support is {}, but must be below ecm.support_floor, which is {}", p.ecm.orphan_support,
                     p.ecm.support_floor);
}

std::string particles(const Parameters& p) {
  const double dp = p.ecm.particle_spacing;
  const double area = p.ecm.lattice == Lattice::hexagonal ? dp * dp * std::numbers::sqrt3 / 2.0 : dp * dp;
  const double count = std::numbers::pi * p.ecm.radius * p.ecm.radius / area;
  if (count <= max_particles) return {};
  return fmt::format("a disc of {:.4g} um at a spacing of {:.4g} um has {:.2g} particles; allowed are {:.2g}",
                     p.ecm.radius, dp, count, max_particles);
}

std::string steps(const Parameters& p) {
  const double count = p.run.duration / p.run.time_step;
  if (count < 1.0 - 1e-9)
    return fmt::format("a step of {:.4g} s is longer than the run of {:.4g} s", p.run.time_step, p.run.duration);
  if (count > max_steps) return fmt::format("the run takes {:.2g} steps; allowed are {:.2g}", count, max_steps);
  return {};
}

constexpr const char* enough_neighbours = "enough neighbours";
constexpr const char* some_is_free = "some matrix is free";
constexpr const char* few_enough = "not too many particles";

/// Those of the laws: each text can be read.
std::vector<Rule> with_laws(std::vector<Rule> rules) {
  std::vector<Rule> all;
  for (const Row& law : law_rows())
    all.push_back({readable_rule(law),
                   {law.path, "laws.constants"},
                   [&law](const Parameters& p) { return fault_of_law(p, law); },
                   {},
                   [&law](const Parameters& p) { return is_changed(law, p); },
                   true});
  std::move(rules.begin(), rules.end(), std::back_inserter(all));
  return all;
}

} // namespace

std::vector<std::string> lattice_rules() { return {enough_neighbours, some_is_free, few_enough}; }

std::string readable_rule(const Row& law) { return fmt::format("{} can be read", law.path); }

std::span<const Rule> rules() {
  static const std::vector<Rule> all = with_laws({
      {enough_neighbours, {"ecm.smoothing_length", "ecm.particle_spacing"}, support},
      {some_is_free, {"ecm.radius", "ecm.smoothing_length", "ecm.particle_spacing"}, room},
      {"the cell fits",
       {"cell.radius", "cell.start_x", "cell.start_y", "degradation.body_distance", "ecm.radius",
        "ecm.smoothing_length"},
       hole,
       {some_is_free}},
      {"a single start belongs to a single cell", {"cell.start_x", "cell.start_y"}, one_start},
      {several_cells_rule,
       {"cell.radius", "degradation.body_distance", "ecm.radius", "ecm.smoothing_length",
        "contact.cells.repulsion_range"},
       several_cells},
      {"the matrix resolves the cell", {"ecm.particle_spacing", "cell.radius"}, resolution},
      {"the nucleus fits into the cell", {"nucleus.radius", "nucleus.repulsion_range", "cell.radius"}, nucleus_fits},
      {"the nucleus is closed", {"nucleus.particles", "nucleus.radius", "nucleus.repulsion_range"}, nucleus_spacing},
      {"a protrusion fits on the cortex", {"protrusion.half_width", "cell.particles"}, protrusion_width},
      {"a tip fits on a protrusion", {"protrusion.tip_half_width", "protrusion.half_width"}, tip_width},
      {"a base lies on its protrusion", {"adhesion.pinned_particles", "protrusion.half_width"}, pinned_base},
      {"orphans have less support than the floor", {"ecm.orphan_support", "ecm.support_floor"}, supports},
      {few_enough, {"ecm.particle_spacing", "ecm.radius", "ecm.lattice"}, particles},
      to_sense(
          "there is attractant to sense", "occupancy", {"ecm.fields.attractant", "ecm.fields.attractant_source"},
          [](const Parameters& p) {
            return !p.ecm.fields.attractant.empty() || !p.ecm.fields.attractant_source.empty();
          },
          "there is no attractant to sense; give ecm.fields.attractant or ecm.fields.attractant_source"),
      to_sense(
          "there is ligand to sense", "ligand", {"ecm.fields.ligand"},
          [](const Parameters& p) { return !p.ecm.fields.ligand.empty(); },
          "ligand is the same everywhere, so there is nothing to sense; give ecm.fields.ligand"),
      to_sense(
          "there are fibres to follow", "alignment", {"fibres.arrangement"},
          [](const Parameters& p) { return p.fibres.arrangement == FibreArrangement::uniaxial; },
          "there are no fibres along a direction to follow; set fibres.arrangement to uniaxial"),
      {"fibres have a stiffness", {"fibres.field.stiffness", "fibres.stiffness"}, fibre_stiffness},
      {"what is released diffuses", {"ecm.fields.attractant_source", "cues.diffusion"}, source},
      {"not too many steps", {"run.time_step", "run.duration"}, steps},
      {change_rule,
       {"run.duration", "run.time_step"},
       [](const Parameters& p) {
         const std::vector<ChangeFault> faults = change_faults(p);
         return faults.empty() ? std::string() : "changes: " + faults.front().message;
       }},
  });
  return all;
}

std::string said_of(const Rule& rule, std::string_view blamed, const std::string& broken) {
  return rule.is_of_first && blamed != rule.keys.front() ? fmt::format("{} {}", rule.keys.front(), broken) : broken;
}

std::vector<CellFault> cell_faults(const Parameters& p) {
  std::vector<CellFault> faults;
  if (!room(p).empty()) return faults;
  const double most = p.ecm.radius - 2.0 * p.ecm.smoothing_length - p.cell.radius - p.degradation.body_distance;
  const double least = 2.0 * p.cell.radius + p.contact.cells.repulsion_range;
  for (std::size_t k = 0; k < p.cells.size(); ++k) {
    const CellStart& a = p.cells[k];
    const double off = std::hypot(a.x, a.y);
    if (off >= most)
      faults.push_back(
          {k, fmt::format("lies {:.4g} um from the centre of the disc, so the cell with its margin reaches the clamped "
                          "rim; allowed is < {:.4g} um, or a larger ecm.radius",
                          off, most)});
    for (std::size_t j = 0; j < k; ++j) {
      const double distance = std::hypot(a.x - p.cells[j].x, a.y - p.cells[j].y);
      if (distance < least * (1.0 - 1e-12))
        faults.push_back({k, fmt::format("lies {:.4g} um from cell {}, centre to centre; allowed is >= {:.4g} um, two "
                                         "radii and the range of the repulsion of cells",
                                         distance, j + 1, least)});
    }
  }
  return faults;
}

} // namespace matrigrate
