#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/file.hpp"
#include "draw/particle_picture.hpp"
#include "draw/text_plot.hpp"
#include "parameters/changes.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/read.hpp"
#include "run/estimate.hpp"
#include "run/folder_state.hpp"
#include "run/run_record.hpp"
#include "simulation/start.hpp"
#include "simulation/start_fields.hpp"
#include "state/cortex.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <utility>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

struct ExplainArguments {
  std::string file;
  std::vector<std::string> overrides;
  bool json = false;
  std::string pictures; ///< folder; empty: none
};

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds)) return "never";
  if (seconds < 120.0) return fmt::format("{:.3g} s", seconds);
  if (seconds < 7200.0) return fmt::format("{:.3g} min", seconds / 60.0);
  return fmt::format("{:.3g} h", seconds / 3600.0);
}

std::string line(std::string_view name, const std::string& value, std::string_view note) {
  return fmt::format("{:<25} {:<15} {}\n", name, value, note);
}

std::string fibres_line(const Parameters& p, const Derived& d) {
  if (p.fibres.arrangement == FibreArrangement::none) return {};
  const auto mean = mean_fibre_direction(p, d);
  const std::string direction = mean ? fmt::format("mean direction {:.3g} degrees", *mean) : "no mean direction";
  if (!p.fibres.field.direction_deg.empty()) return line("fibres", "along a field", direction + " over the particles");
  return line("fibres", fmt::format("{} bonds", d.bonds.count), "of each particle; " + direction);
}

std::string description(const Parameters& p, const Derived& d) {
  std::string text;
  const std::size_t cells = cell_starts(p).size();
  const bool graded = !p.ecm.fields.youngs_modulus.empty();
  text += fmt::format("{} of {:.4g} um radius in a disc of matrix of {:.4g} um radius ({}, Poisson's ratio "
                      "{:.4g},\nviscosity {:.4g} Pa s), "
                      "clamped at its rim, followed for {} in steps of {}{:.4g} s.\n\n",
                      cells == 1 ? std::string("A cell") : fmt::format("{} cells", cells), p.cell.radius, p.ecm.radius,
                      graded ? "E by a field" : fmt::format("{:.4g} Pa", 1e3 * p.ecm.youngs_modulus),
                      p.ecm.poissons_ratio, 1e3 * p.ecm.viscosity, duration_text(p.run.duration),
                      p.run.integrator == Integrator::adaptive ? "up to " : "", d.longest_step);
  text += line("bulk modulus K", fmt::format("{:.4g} Pa", 1e3 * d.K),
               std::string("E / (3 (1 - 2 nu))") + (graded ? "; here and below E is ecm.youngs_modulus" : ""));
  text += line("shear modulus G", fmt::format("{:.4g} Pa", 1e3 * d.G), "E / (2 (1 + nu))");
  text += line("relaxation in shear", duration_text(d.shear_time), "mu / G");
  text += line("relaxation, compression", duration_text(d.compression_time), "mu / (K + 4G/3)");
  text += line("particles", fmt::format("{}", d.particles()),
               fmt::format("{} free, {} of them fluid from the start; {} clamped", d.free_particles, d.fluid_particles,
                           d.clamped_particles));
  text += line("neighbours", fmt::format("{:.0f}", d.neighbours), "of a particle, within the kernel's support of 2 h");
  text += line("cortex", fmt::format("{:.3g} um", d.segment_length),
               fmt::format("a segment of {}; a protrusion takes {:.3g} um", p.cell.particles, d.protrusion_width));
  text += line("first protrusion", duration_text(d.first_wait),
               fmt::format("on average; after that a cell without any waits {}", duration_text(d.wait)));
  text += line("steps", fmt::format("{:.0f}", d.steps),
               p.run.integrator == Integrator::adaptive ? "at least: duration / longest step" : "duration / time step");
  text += line("largest stable step", fmt::format("{:.3g} s", largest_step(p, d.limits)),
               "set by the " + d.limits.binding());
  if (const auto quicker = with_longer_steps(p, d))
    text += line("integrator", "reference",
                 fmt::format("run.integrator = \"adaptive\" with run.time_step = \"{:.2g} s\" would take {}",
                             quicker->time_step, duration_text(quicker->wall_time)));
  else
    text += line("integrator", p.run.integrator == Integrator::reference ? "reference" : "adaptive", "");
  text += fibres_line(p, d);
  for (const FieldSummary& field : field_summaries(p).fields)
    text += line(fmt::format("field {}", key_of(*field.row)),
                 fmt::format("{:.4g} to {:.4g}{}", field.low, field.high,
                             field.row->unit == "1" ? "" : fmt::format(" {}", field.row->unit)),
                 fmt::format("{}; {}", section_of(*field.row), field.source));
  text += line("memory", fmt::format("{:.0f} MB", d.cost.memory_bytes / 1e6), "estimate");
  text += line("disk", fmt::format("{:.0f} MB", d.cost.disk_bytes / 1e6), "estimate; [output] of the scenario decides");
  const int threads = run::threads_of(p, d.particles()), most = run::threads_that_pay(d.particles());
  text +=
      line("threads", fmt::format("{}", threads),
           p.run.threads > 0 ? "run.threads"
           : threads == most ? "pay for so many particles"
                             : fmt::format("of {} that pay for so many particles: no more cores are idle now", most));
  text += line("wall time", duration_text(d.cost.wall_time),
               "estimate, on one thread; see the notes of `matrigrate explain -h`");
  return text;
}

/// Each changed law, drawn beside the default one.
std::string laws_text(const Parameters& p) {
  std::string text;
  for (const Row* law : changed_laws(p)) {
    text += fmt::format("\n{} = {}\n{}{}; * here, . by default\n", law->path, value_text(*law, p), law->description,
                        law->unit == "1" ? "" : fmt::format(", in {}", law->unit));
    if (const std::string constants = constants_of(*law, p); !constants.empty())
      text += fmt::format("where {}\n", constants);
    text += "checked, on a grid, over";
    const std::vector<LawVariable> variables = law_variables(*law, text_of(*law, p), p);
    for (const LawVariable& argument : variables)
      text +=
          fmt::format("{} {} from {}", &argument == variables.data() ? "" : ",", argument.name, range_text(argument));
    text += "\n";
    for (LawCurve& curve : law_curves(p, *law, 241)) {
      if (!curve.at.empty()) text += fmt::format("at {}:\n", curve.at);
      text += draw::to_text({.x_name = curve.over.name,
                             .x_unit = curve.over.unit,
                             .x_low = curve.over.drawn_low,
                             .x_high = curve.over.drawn_high,
                             .points = std::move(curve.changed),
                             .comparison = std::move(curve.usual)});
    }
  }
  return text;
}

/// Of each changed law, the ranges over which it is checked.
Json ranges_json(const Parameters& p) {
  Json all = Json::object();
  for (const Row* law : changed_laws(p))
    for (const LawVariable& argument : law_variables(*law, text_of(*law, p), p))
      all[std::string(law->path)][std::string(argument.name)] = {
          {"low", argument.low}, {"high", argument.high}, {"unit", argument.unit}};
  return all;
}

Json fields_json(const Parameters& p) {
  Json list = Json::array();
  for (const FieldSummary& field : field_summaries(p).fields)
    list.push_back({{"key", field.row->path},
                    {"unit", field.row->unit},
                    {"source", field.source},
                    {"least", field.low},
                    {"largest", field.high}});
  return list;
}

Json to_json(const ExplainArguments& options, const Parameters& p, const Derived& d,
             const std::vector<std::string>& found) {
  const auto quicker = with_longer_steps(p, d);
  const auto direction = mean_fibre_direction(p, d);
  return {{"file", options.file},
          {"cells", cell_starts(p).size()},
          {"bulk_modulus_Pa", 1e3 * d.K},
          {"shear_modulus_Pa", 1e3 * d.G},
          {"shear_relaxation_s", d.shear_time},
          {"compression_relaxation_s", d.compression_time},
          {"particles", d.particles()},
          {"free_particles", d.free_particles},
          {"clamped_particles", d.clamped_particles},
          {"fluid_particles", d.fluid_particles},
          {"neighbours", d.neighbours},
          {"cortex_segment_um", d.segment_length},
          {"protrusion_width_um", d.protrusion_width},
          {"mean_wait_first_protrusion_s", d.first_wait},
          {"mean_wait_protrusion_s", d.wait},
          {"steps", d.steps},
          {"step_limit_elastic_s", d.limits.elastic_s},
          {"step_limit_fluid_s", d.limits.fluid_s},
          {"step_limit_set_by", d.limits.binding()},
          {"fibre_bonds_of_a_particle", d.bonds.count},
          {"fibre_mean_direction_deg", direction ? Json(*direction) : Json()},
          {"fields", fields_json(p)},
          {"laws", run::laws_json(p)},
          {"law_ranges", ranges_json(p)},
          {"changes", run::changes_json(p)},
          {"memory_estimate_bytes", d.cost.memory_bytes},
          {"disk_estimate_bytes", d.cost.disk_bytes},
          {"wall_time_estimate_s", d.cost.wall_time},
          {"adaptive_time_step_s", quicker ? Json(quicker->time_step) : Json()},
          {"adaptive_wall_time_estimate_s", quicker ? Json(quicker->wall_time) : Json()},
          {"warnings", found}};
}

/// What a field is, in words: "Young's modulus of the intact matrix".
std::string words_of(const Row& row) {
  const std::string_view clause = row.description.substr(0, row.description.find_first_of(";:,("));
  std::string words(clause.substr(0, clause.find(" as a function of position")));
  while (words.ends_with(' ')) words.pop_back();
  return words;
}

/// Draws each field of a scenario, with the cell's outline at the start, into a new folder.
void draw_fields(const Parameters& p, const std::string& folder) {
  const FieldSummaries given = field_summaries(p);
  if (given.fields.empty())
    throw UsageError("the scenario has no fields to draw; docs/how-to/fields.md shows how to add them");
  require(run::look_at(folder), run::Use::pictures);
  make_folder(folder);
  const std::vector<Vec2> outline = round_cortex(p.cell).x;
  for (const FieldSummary& field : given.fields) {
    const std::string unit = field.row->unit == "1" ? std::string() : fmt::format(" ({})", field.row->unit);
    const draw::ParticlePicture picture{.title = words_of(*field.row),
                                        .value_label = words_of(*field.row) + unit,
                                        .position = given.places,
                                        .value = field.values,
                                        .particle_size = p.ecm.particle_spacing,
                                        .outlines = {outline}};
    const auto file = std::filesystem::path(folder) / fmt::format("{}.svg", field.row->path);
    write_file(file, draw::to_svg(picture, 900));
    print(fmt::format("{}\n", file.string()));
  }
}

int explain(const ExplainArguments& options) {
  const Parameters p = read_parameters(options.file, options.overrides, formula_rules());
  if (!options.pictures.empty()) {
    draw_fields(p, options.pictures);
    return done;
  }
  const Derived d = derived(p);
  const std::vector<std::string> found = warnings(p, d);
  if (options.json) {
    print_json(to_json(options, p, d, found));
    return done;
  }
  print(description(p, d) + laws_text(p));
  if (!p.changes.empty()) print("\n");
  for (const ChangeWords& change : words_of_changes(p)) print(to_text(change) + "\n");
  for (const std::string& warning : found)
    print(fmt::format("\n{} {}\n", coloured("WARNING:", Colour::warning, Stream::out), warning));
  return done;
}

} // namespace

void add_explain(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("explain", "What a scenario means and needs, before anything is computed");
  verb->footer(wall_time_basis()
               + "\n--json prints one object whose keys carry their units, with the list `warnings`.");
  const auto options = std::make_shared<ExplainArguments>();
  verb->add_option("FILE", options->file, "A scenario file")->required();
  verb->add_option("--set", options->overrides, "key=value, over the file; may be repeated")->allow_extra_args(false);
  verb->add_flag("--json", options->json, "Print the numbers as JSON");
  verb->add_option("--pictures", options->pictures, "Draw the fields of the scenario into this new folder instead");
  verb->callback([options, &chosen] { chosen = [options] { return explain(*options); }; });
}

} // namespace matrigrate::apps
