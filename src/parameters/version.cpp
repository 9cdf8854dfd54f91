#include "parameters/version.hpp"

#include "parameters/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <sstream>

namespace matrigrate {

namespace {

/// {0, 2, 0} of "0.2.0"; what is no number counts as 0.
std::array<int, 3> numbers_of(std::string_view version) {
  std::array<int, 3> all{};
  for (int& number : all) {
    const std::size_t dot = std::min(version.find('.'), version.size());
    std::from_chars(version.data(), version.data() + dot, number);
    version.remove_prefix(std::min(dot + 1, version.size()));
  }
  return all;
}

constexpr std::string_view no_snapshots =
    "a run draws no snapshots: its page plays it, export --png and --panel draw frames, --layer chooses the layer";

constexpr std::array profiles{GoneFormula{"\"gaussian\"", "exp(-((kappa - kappa_0)/kappa_w)^2)"},
                              GoneFormula{"\"triangle\"", "max(0, 1 - abs(kappa - kappa_0)/kappa_w)"}};
constexpr std::array of_chemotaxis{GoneFormula{"", "exp({}*occupancy)"}};
constexpr std::array of_haptotaxis{GoneFormula{"", "exp({}*ligand)"}};
constexpr std::array of_guidance{GoneFormula{"", "exp({}*alignment)"}};

constexpr Gone drawing(std::string_view path, std::string_view behind, std::string_view left) {
  return {path, behind, left, "", no_snapshots, {}, {}, true};
}

constexpr std::array parameters{
    Gone{"ecm.formulation", "ecm.thickness", "\"total_lagrangian\"", "",
         "the stress of the solid is summed over reference neighbours"},
    Gone{"fibres.law", "fibres.stiffening_strain", "\"tangent\"", "", "Eq. 5 is the tangent stiffness of a fibre"},
    Gone{"fibres.pull", "fibres.stiffening_strain", "\"axial\"", "", "a fibre pulls along itself"},
    Gone{"fibres.plane_to_space", "fibres.stiffening_strain", "false", "",
         "k_0 is fibres.stiffness; write 8/15 of it there"},
    Gone{"cell.centre_of_mass", "cell.radius", "\"particles\"", "\"area\"",
         "the centre of mass is the mean of the cortex particles"},
    Gone{"actomyosin.curvature_profile", "actomyosin.curvature_width", "\"half_gaussian\"", "", "",
         "laws.curvature_factor", profiles},
    Gone{"protrusion.growing_base", "protrusion.least_facing", "\"tied\"", "",
         "the base of a growing protrusion is tied"},
    Gone{"adhesion.rupture_strands", "adhesion.rupture_ratio", "2", "",
         "rupture and f_adh_rel count both strands; adhesion.rupture_ratio = 0.5 ruptures at the force of one"},
    Gone{"adhesion.handover", "adhesion.rest_speed", "\"bundle\"", "",
         "contraction replaces the pull of maturation as the cortex takes over the load, in adhesion.handover_time"},
    Gone{"adhesion.hold", "adhesion.maturation_strands", "\"matter\"", "\"place\"",
         "an adhesion holds the matter that was there when it formed"},
    Gone{"polarization.turning", "polarization.rate", "\"proportional\"", "",
         "the polarization turns in proportion to the angle"},
    Gone{"degradation.pressure", "degradation.body_rear_share", "\"sum\"", "",
         "the larger pressure and degradation.smaller_share of the smaller one are added; smaller_share = 0 is the "
         "larger pressure alone"},
    Gone{"cues.chemotaxis", "", "0", "", "", "laws.initiation_bias", of_chemotaxis},
    Gone{"cues.haptotaxis", "", "0", "", "", "laws.initiation_bias", of_haptotaxis},
    Gone{"cues.guidance", "", "0", "", "", "laws.initiation_bias", of_guidance},
    drawing("output.snapshot_interval", "output.track_interval", "\"1800 s\""),
    drawing("output.pictures", "output.report", "true"),
    drawing("output.displacement_layer", "output.report", "false"),
    drawing("output.fibre_stress_layer", "output.report", "true"),
};

} // namespace

bool has_this_model(std::string_view version) {
  const auto asked = numbers_of(version);
  return asked >= numbers_of(model_since) && asked <= numbers_of(this_version);
}

std::string version_of_program(std::string_view program) {
  const std::size_t name = program.find(' ');
  if (name != std::string_view::npos) program.remove_prefix(name + 1);
  return std::string(program.substr(0, program.find(' ')));
}

std::string model_text(std::string_view version) {
  if (has_this_model(version)) return {};
  if (numbers_of(version) > numbers_of(this_version))
    return fmt::format("{} is a later version, whose model may be another: results may differ, not only bits", version);
  return fmt::format(
      "the model has changed since {}: results differ, not only bits, most where adhesions mature within "
      "a few time steps",
      version);
}

std::span<const Gone> gone() { return parameters; }

const Gone* find_gone(std::string_view path) {
  const auto found = std::ranges::find(parameters, path, &Gone::path);
  return found == parameters.end() ? nullptr : &*found;
}

std::string gone_value(const toml::node& value) {
  if (const auto text = value.value_exact<std::string>()) return fmt::format("\"{}\"", excerpt(*text));
  if (const auto number = value.value_exact<double>()) return fmt::format("{}", *number);
  std::ostringstream text;
  value.visit([&](const auto& typed) { text << typed; });
  return excerpt(text.str());
}

std::string gone_value(const Gone& parameter, const Parameters& p) {
  const auto kept = p.origin.gone.find(parameter.path);
  return kept == p.origin.gone.end() ? std::string(parameter.left) : kept->second;
}

std::string gone_text(std::string_view value, const Gone& parameter) {
  if (parameter.is_drawing) return fmt::format("{} has gone: {}", value, parameter.fate);
  if (parameter.law.empty())
    return fmt::format("{} has gone: {}; the version of the tag closures-2 has the other readings", value,
                       parameter.fate);
  std::string text;
  for (const GoneFormula& one : parameter.formulas)
    text += fmt::format("{}\"{}\"{}", text.empty() ? "" : ", ", fmt::format(fmt::runtime(one.formula), value),
                        one.value.empty() ? std::string() : fmt::format(" for {}", one.value));
  return fmt::format("{} has gone: write {} = {}", value, parameter.law, text);
}

std::optional<std::string> formula_of_gone(const Gone& parameter, std::string_view value) {
  for (const GoneFormula& one : parameter.formulas)
    if (one.value.empty() || one.value == value) return fmt::format(fmt::runtime(one.formula), value);
  return std::nullopt;
}

std::string fault_of_gone(const Gone& parameter, const toml::node& value) {
  const std::string given = gone_value(value);
  return parameter.is_drawing || given == parameter.left ? "" : gone_text(given, parameter);
}

std::vector<Fault> faults_of_gone(const Parameters& p, const std::string& place) {
  std::vector<Fault> faults;
  for (const auto& [path, value] : p.origin.gone)
    faults.push_back({place, 0, 0, path, gone_text(value, *find_gone(path))});
  return faults;
}

} // namespace matrigrate
