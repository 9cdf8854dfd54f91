#include "run/estimate.hpp"

#include "base/parallel.hpp"
#include "base/text.hpp"
#include "cues/sensing.hpp"
#include "ecm/law/material.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/version.hpp"
#include "simulation/start.hpp"
#include "simulation/start_fields.hpp"
#include "state/cortex.hpp"
#include "state/initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace matrigrate::run {

namespace {

// Measured with one thread on a server (AMD EPYC), release build: six hours of the baseline at 2.9 ms a step of 17,665
// particles, 5,000 adaptive steps of up to 5 s at 3.9 ms; a decade of the tolerance costs 0.3 ms. A run takes 70 MB
// before its end. Conjugate gradients took 3.4 R/h iterations to 1e-6. The cell takes 0.18 of a step of the baseline:
// on a busier machine 0.66 of 3.7 ms, in proportion to its 118, 235 or 470 particles, in discs of 40 to 150 um.
constexpr double seconds_a_pair = 3.2e-9;
constexpr double seconds_a_pair_and_decade = 0.6e-9;
constexpr double seconds_a_cell_particle = 2.2e-6;
constexpr double of_longer_steps = 1.6; // a step of the adaptive integrator, halved ones included
constexpr double seconds_a_pair_and_iteration = 1.0e-9;
constexpr double iterations_a_radius = 3.4 / 6.0; // of conjugate gradients, for each decade of the tolerance
// Measured: runs of one step, with all files, in discs of 1,256 to 70,681 particles take 0.06 to 0.8 s of CPU time.
constexpr double seconds_to_begin = 0.05;
constexpr double seconds_a_particle_to_begin = 1.1e-5;
constexpr double bytes_alone = 20e6;
constexpr double bytes_a_particle = 600.0;
constexpr double bytes_a_pair = 75.0;

/// Mean number of particles within a distance of a point of the lattice, itself left out.
double particles_within(double reach, const EcmParameters& ecm) {
  return std::numbers::pi * reach * reach / particle_area(ecm) - 1.0;
}

double times(const Parameters& p, double interval) {
  return interval > 0.0 ? std::floor(p.run.duration / interval) : 0.0;
}
double frames(const Parameters& p) {
  return p.output.field_interval > 0.0 ? times(p, p.output.field_interval) + 1.0 : 0.0;
}

// Measured: 76 to 85 MB at the end of a run with 73 frames of 17,665 particles, when little else is left.
constexpr double bytes_a_particle_and_frame = 50.0;

// Measured: six hours of the baseline, 17,665 particles, leave 25.4 MB of fields and 2.3 MB of report in 73 frames,
// 3.2 MB a checkpoint, and 250 bytes a row of the tables.
double disk_bytes(const Parameters& p, double particles) {
  const OutputParameters& out = p.output;
  return 8e4 + 250.0 * (times(p, out.track_interval) + 2.0)
         + particles
               * (frames(p) * (19.7 + (out.report ? 1.7 : 0.0))
                  + 180.0 * (2.0 + times(p, out.kept_checkpoint_interval)));
}

double steps(const Parameters& p) { return std::ceil(p.run.duration / p.run.time_step - 1e-9); }

double listed_neighbours(const EcmParameters& ecm) {
  return particles_within(2.0 * ecm.smoothing_length + ecm.verlet_skin, ecm);
}

double wall_time(const Parameters& p, double particles) {
  const double decades = -std::log10(p.solver.tolerance);
  const double solve = p.solver.method == SolverMethod::multigrid
                           ? seconds_a_pair_and_decade
                           : seconds_a_pair_and_iteration * iterations_a_radius * p.ecm.radius / p.ecm.smoothing_length;
  const double longer = p.run.integrator == Integrator::adaptive ? of_longer_steps : 1.0;
  return seconds_to_begin + seconds_a_particle_to_begin * particles
         + longer * steps(p)
               * (particles * listed_neighbours(p.ecm) * (seconds_a_pair + decades * solve)
                  + static_cast<double>(cell_starts(p).size()) * p.cell.particles * seconds_a_cell_particle);
}

/// Rate at which a particle of the cell at the start initiates protrusions, in the mean along its cortex [1/s].
double initiation_rate(const Parameters& p, const State& start) {
  if (start.cells.empty()) return p.protrusion.initiation_rate;
  const std::vector<double> rate = along_cortex(Law("laws.initiation_rate", p), start.cells.front(), start.ecm, p);
  return std::accumulate(rate.begin(), rate.end(), 0.0) / static_cast<double>(rate.size());
}

} // namespace

std::size_t particle_count(const Parameters& p) { return lattice_patch(p.ecm, p.ecm.radius).size(); }

RunCost run_cost(const Parameters& p, std::size_t particles) {
  const auto n = static_cast<double>(particles);
  return {.memory_bytes = bytes_alone
                          + n
                                * std::max(bytes_a_particle + listed_neighbours(p.ecm) * bytes_a_pair,
                                           frames(p) * bytes_a_particle_and_frame),
          .disk_bytes = disk_bytes(p, n),
          .wall_time = wall_time(p, n)};
}

Derived derived(const Parameters& p) {
  const State start = initial_state(p);
  const EcmState& ecm = start.ecm;
  const double initiation = initiation_rate(p, start);
  const Moduli m = moduli(p.ecm);
  const auto clamped = static_cast<std::size_t>(std::ranges::count(ecm.clamped, 1));
  const int in_front = p.cell.particles / 2;
  const StepLimits limits = step_limits(as_stiff_everywhere(p));
  Parameters as_run = p;
  as_run.run.time_step = longest_step(p, limits);
  return {.K = m.K,
          .G = m.G,
          .shear_time = p.ecm.viscosity / m.G,
          .compression_time = p.ecm.viscosity / m.longitudinal(),
          .free_particles = ecm.size() - clamped,
          .clamped_particles = clamped,
          .fluid_particles = static_cast<std::size_t>(std::ranges::count(ecm.f, 0.0)),
          .neighbours = static_cast<double>(lattice_patch(p.ecm, 2.0 * p.ecm.smoothing_length).size()) - 1.0,
          .segment_length = initial_segment_length(p.cell),
          .protrusion_width = 2.0 * p.protrusion.half_width * initial_segment_length(p.cell),
          .first_wait = 1.0 / (p.cell.particles * initiation),
          .wait = 1.0 / (in_front * initiation),
          .longest_step = as_run.run.time_step,
          .steps = steps(as_run),
          .limits = limits,
          .bonds = fibre_bonds(p),
          .cost = run_cost(as_run, ecm.size())};
}

std::optional<double> mean_fibre_direction(const Parameters& p, const Derived& d) {
  if (p.fibres.field.direction_deg.empty()) return d.bonds.mean_deg;
  double x = 0.0, y = 0.0; // of axes: angles count twice
  std::size_t count = 0;
  for (const FieldSummary& field : field_summaries(p).fields)
    if (field.row->path == "fibres.field.direction_deg")
      for (const double degrees : field.values) {
        x += std::cos(degrees * std::numbers::pi / 90.0);
        y += std::sin(degrees * std::numbers::pi / 90.0);
        ++count;
      }
  if (std::hypot(x, y) <= 1e-2 * static_cast<double>(count)) return std::nullopt;
  const double mean = std::atan2(y, x) * 90.0 / std::numbers::pi;
  return mean < 0.0 ? mean + 180.0 : mean;
}

std::optional<Quicker> with_longer_steps(const Parameters& p, const Derived& d) {
  if (p.run.integrator == Integrator::adaptive) return std::nullopt;
  Parameters q = p;
  q.run.integrator = Integrator::adaptive;
  q.run.time_step = std::min(usual_time_step(Integrator::adaptive), p.run.duration);
  q.run.time_step = longest_step(q, d.limits);
  if (q.run.time_step <= p.run.time_step) return std::nullopt;
  return Quicker{q.run.time_step, wall_time(q, static_cast<double>(d.particles()))};
}

std::string fault_of_bias(const Parameters& p) {
  const Law bias("laws.initiation_bias", p);
  if (!bias.varies() && bias({0.0, 0.0, 0.0, 0.0, 0.0}) > 0.0) return {};
  const State start = initial_state(p);
  if (start.cells.empty()) return {};
  for (const Cell& cell : start.cells)
    if (!propensity(cell, start.ecm, p, bias).empty()) return {};
  return "laws.initiation_bias is 0 along the whole cortex at the start; protrusions begin there as without a bias";
}

std::string cost_of_reference_steps(const Parameters& p) {
  constexpr double worth_telling = 10.0; // [s]
  if (p.run.integrator == Integrator::adaptive) return {};
  const Derived d = derived(p);
  const auto quicker = with_longer_steps(p, d);
  if (!quicker || d.cost.wall_time < std::max(2.0 * quicker->wall_time, quicker->wall_time + worth_telling)) return {};
  return fmt::format("takes the reference steps of {:.3g} s throughout, about {} on one thread; run.integrator = "
                     "\"adaptive\" would take about {}",
                     p.run.time_step, wall_time_text(d.cost.wall_time), wall_time_text(quicker->wall_time));
}

std::vector<std::string> uneven_outputs(const Parameters& p) {
  std::vector<std::string> found;
  const auto look_at = [&](const char* key, double interval, const char* what) {
    const double steps = interval / p.run.time_step;
    if (interval <= 0.0 || interval >= p.run.duration || std::abs(steps - std::round(steps)) <= 1e-6 * steps) return;
    found.push_back(fmt::format("{0}, {1:g} s, is no multiple of run.time_step, {2:g} s: the {3} will not be evenly "
                                "spaced, and formats that suppose one interval will be refused; {4:g} s would be one",
                                key, interval, p.run.time_step, what,
                                p.run.time_step * std::max(1.0, std::round(steps))));
  };
  look_at("output.track_interval", p.output.track_interval, "rows of tracks.csv");
  look_at("output.field_interval", p.output.field_interval, "frames");
  return found;
}

std::string note_of_scenario(const Parameters& p) {
  if (p.origin.version.empty()) return {};
  return fmt::format("the scenario was written by matrigrate {}, of whose runs this program repeats no bits: {}",
                     p.origin.version, model_text(p.origin.version));
}

std::string note_of_drag(const Parameters& p) {
  if (p.contact.body_fluid_share <= p.contact.fluid_share) return {};
  return fmt::format("fluid drags the body more than the protrusions: contact.body_fluid_share, {:.6g}, is above "
                     "contact.fluid_share, {:.6g}; in all sets of closures it is not",
                     p.contact.body_fluid_share, p.contact.fluid_share);
}

int threads_that_pay(std::size_t particles) {
  // Measured: with 17,665 particles a second thread takes 41 % of the time off. A sixth of a run is
  // serial, so that a fifth would bring 11 %.
  constexpr std::size_t of_a_thread = 8000, most = 4;
  return static_cast<int>(std::clamp<std::size_t>(particles / of_a_thread, 1, most));
}

int threads_of(const Parameters& p, std::size_t particles) {
  return p.run.threads > 0 ? p.run.threads : std::min(threads_that_pay(particles), idle_threads());
}

std::string wall_time_basis() {
  return "The wall time rests on the measured cost of the baseline on one core of a server: 3.2 ns a step for each\n"
         "listed pair of particles, 0.6 ns for each decade of solver.tolerance, and 2.2 us for each particle of a "
         "cell;\n"
         "1.6 times that for each step of the adaptive integrator; and 0.05 s a run with 0.011 ms a particle to begin\n"
         "and to write files. A second thread makes runs 1.7 times faster in discs of 150 um, 1.8 times in discs of\n"
         "300 um. A machine with other work to do takes longer.";
}

std::vector<std::string> warnings(const Parameters& p, const Derived& d) {
  std::vector<std::string> found;
  const double limit = largest_step(p, d.limits);
  const std::string too_long = fault_of_step(p, d.limits);
  const std::string no_fibres = fault_of_fibres(p);
  if (!no_fibres.empty()) found.push_back(no_fibres + ". A run of it is refused.");
  if (!too_long.empty())
    found.push_back(too_long + ". A run of it is refused, since errors would grow from step to step.");
  else if (p.run.integrator == Integrator::reference && p.run.time_step > 0.5 * limit)
    found.push_back(
        fmt::format("the time step of {:.3g} s is more than half of the largest stable one, {:.3g} s: stable, but "
                    "the fastest relaxation is resolved by a few steps only.",
                    p.run.time_step, limit));
  for (const FieldSummary& field : field_summaries(p).fields)
    if (field.row->path == "ecm.fields.obstacle" && !in_obstacle(field.high))
      found.emplace_back("no matrix particle lies in an obstacle: ecm.fields.obstacle is below 0.5 at every particle. "
                         "Particles lie ecm.particle_spacing apart.");
  if (p.run.duration < d.shear_time)
    found.push_back(
        fmt::format("the run of {:.3g} s is shorter than the relaxation of the matrix in shear, {:.3g} s: the "
                    "matrix will look like a fluid.",
                    p.run.duration, d.shear_time));
  for (const std::string& sentence : uneven_outputs(p)) found.push_back(sentence + ".");
  if (const std::string bias = fault_of_bias(p); !bias.empty()) found.push_back(bias + ".");
  for (const std::string& sentence : law_notes(p)) found.push_back(sentence + ".");
  for (const std::string& note : {closures_of(p).note, note_of_scenario(p), note_of_drag(p)})
    if (!note.empty()) found.push_back(note + ".");
  if (p.ecm.hourglass_weight == 0.0)
    found.emplace_back("without the hourglass penalty, particles pair up and drift in modes that cost no energy.");
  return found;
}

} // namespace matrigrate::run
